// Project files (.pastoso): a painting saved and opened again (docs/file-format.md).
#pragma once

#include "core/message.hpp"
#include "core/output_file.hpp"
#include "core/progress.hpp"
#include "core/thread_pool.hpp"
#include "document/events.hpp"
#include "document/painting_state.hpp"

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <vector>

namespace pastoso::project {

/// A painting and what was done to it.
struct Project {
    document::PaintingState painting;
    document::Recording strokes;  ///< of the painting's canvas, no event later than its tick
};

/// What was read, and what a painter should know of it, in sentences.
struct LoadedProject : Project {
    std::vector<core::Message> notes;
};

/// Writes aside, flushes and renames: at any moment `path` is the old file or the whole new one. The
/// same painting gives the same bytes. Throws InputError when the file cannot be written.
void save_project(const std::filesystem::path& path, const Project& project, core::ThreadPool& pool,
                  core::Replaced = core::Replaced::Writable);

/// Reads the whole file and checks everything that a painting relies on; what it names is never opened.
/// Throws InputError "FILE, PLACE: ..." for a file that is damaged, foreign, written by a newer version,
/// or too large for this machine's memory.
///
/// The bare support is made anew from its name where nothing lies on it. Where a version of the program
/// makes it otherwise, and where strokes cannot be read, the painting is loaded nevertheless, with a
/// note.
LoadedProject load_project(const std::filesystem::path& path, core::ThreadPool& pool,
                           const core::Progress& progress = {});

/// The same of a file in memory; `name` stands for it in errors.
LoadedProject parse_project(std::span<const std::byte> file, const std::string& name,
                            core::ThreadPool& pool);

/// The strokes of a project alone: what load_project() gives of them. `notes` gets the sentence of
/// strokes that cannot be read.
document::Recording load_strokes(const std::filesystem::path& path, std::vector<core::Message>& notes);

/// The picture that file managers show of a project: a PNG file, at most 256 pixels a side.
std::string load_thumbnail(const std::filesystem::path& path);

/// The same, made smaller where a side is longer than that.
std::string load_thumbnail(const std::filesystem::path& path, int longest_px);

/// How many bytes a kind of data takes, and how many it would without compression.
struct KindSize {
    std::string kind{};
    std::size_t packed_bytes = 0, bytes = 0;
};

/// What can be said of a project without loading it.
struct ProjectSummary {
    document::CanvasSettings canvas;
    std::string program;  ///< the version that wrote it
    std::int64_t tick = 0;
    std::string medium{};
    std::string brush{};  ///< in hand, "" for none
    std::vector<KindSize> sizes{};
};
ProjectSummary project_summary(const std::filesystem::path& path);

/// Whether a file's name ends in .pastoso.
bool is_project_path(const std::filesystem::path& path);

}  // namespace pastoso::project
