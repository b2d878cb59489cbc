// Small paintings that the tests of this folder save.
#pragma once

#include "core/thread_pool.hpp"
#include "document/painting.hpp"
#include "project/project.hpp"

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

namespace pastoso::project {

/// Everything that a project file keeps is used: running and dried paint, the well, a loaded brush.
document::Recording busy_session();

/// The recording played up to a tick at which no stroke is in progress.
std::unique_ptr<document::Painting> played(const document::Recording& recording, std::int64_t tick,
                                           core::ThreadPool& pool);

/// The painting with the recording up to its tick.
Project project_of(const document::Painting& painting, const document::Recording& recording);

/// busy_session() half-way, where paint still runs.
Project busy_project(core::ThreadPool& pool);

/// The file that save_project() makes of it.
std::vector<std::byte> file_of(const Project& project, const std::filesystem::path& folder,
                               core::ThreadPool& pool);

/// The same with a grey picture for other programs: the painting may hold what nobody could paint.
std::vector<std::byte> unseen_file_of(const Project& project, const std::filesystem::path& folder,
                                      core::ThreadPool& pool);

std::vector<std::byte> bytes_in(const std::filesystem::path& path);

}  // namespace pastoso::project
