// A project as the entries of an archive.
#pragma once

#include "project/pictures.hpp"
#include "project/project.hpp"

#include <filesystem>
#include <string>

namespace pastoso::project {

/// Writes to `path`, where a file may stand, everything that save_project() writes; other programs see
/// `pictures`. Throws as ZipWriter::write() does.
void write_archive(const Project& project, const Pictures& pictures, core::ThreadPool& pool,
                   const std::filesystem::path& path, const std::string& name);

}  // namespace pastoso::project
