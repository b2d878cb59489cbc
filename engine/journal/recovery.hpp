// Paintings that a program left unfinished, however it ended.
#pragma once

#include "core/message.hpp"
#include "core/thread_pool.hpp"
#include "journal/journal_file.hpp"
#include "journal/journal_folder.hpp"
#include "project/project.hpp"

#include <chrono>
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace pastoso::journal {

/// What can be said of an abandoned journal without replaying it.
struct Unfinished {
    std::filesystem::path folder;
    std::string painting{};  ///< path of its project file, empty for a painting that has none
    document::CanvasSettings canvas{};
    std::chrono::system_clock::time_point last_painted{};
    std::size_t changes = 0;  ///< strokes and the like since it was saved
    std::int64_t tick = 0;
    bool damaged = false;
    std::string thumbnail{};  ///< a PNG file of a moment before; empty where there is none
    core::Message fault{};    ///< why it cannot be read; all but the folder and the time is empty then
};

/// The journals in `root` that no program holds and that have something to recover, the latest first.
/// Those of paintings that were saved and not changed since, or never touched, are removed.
std::vector<Unfinished> unfinished_paintings(const std::filesystem::path& root);

/// The picture of what recover() gives, a PNG file as Unfinished::thumbnail is. Takes as long.
std::string recovered_thumbnail(const std::filesystem::path& folder, core::ThreadPool& pool,
                                const core::Progress& progress = {});

struct Recovered : project::Project {
    std::string file{};                  ///< path of its project file, empty for a painting without one
    std::vector<core::Message> notes{};  ///< what is missing, in sentences
};

/// The painting as it was when its journal ends; a stroke in progress ends there. Begins at the latest
/// point from where the replay is exact: the start of the journal or a checkpoint. Where frames are
/// damaged, as much as there is. `progress` gets the share that is done, 0 to 1. Throws InputError in
/// one sentence when nothing can be had.
Recovered recover(const std::filesystem::path& folder, core::ThreadPool& pool,
                  const core::Progress& progress = {});

}  // namespace pastoso::journal
