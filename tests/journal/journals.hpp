// Journals as a program leaves them.
#pragma once

#include "document/painting.hpp"
#include "document/player.hpp"
#include "journal/journal_writer.hpp"
#include "journal/recovery.hpp"

#include <algorithm>
#include <filesystem>
#include <memory>
#include <set>

namespace pastoso::journal {

/// Plays the recording with a journal in `root`; after as many actions as are in `checkpoints`, a
/// checkpoint is written. The journal is left behind; returns its folder.
inline std::filesystem::path left_behind(const std::filesystem::path& root,
                                         const document::Recording& recording,
                                         const std::set<std::size_t>& checkpoints,
                                         core::ThreadPool& pool) {
    document::Painting painting(recording.canvas, pool);
    JournalWriter journal(root, {.canvas = recording.canvas}, {.flush_s = 0.001, .rests = 0.0});
    std::size_t next = 0;
    while (true) {
        for (; next < recording.events.size() && recording.events[next].tick <= painting.tick();
             ++next) {
            painting.apply(recording.events[next].action);
            journal.note(recording.events[next]);
            if (!checkpoints.contains(next + 1)) continue;
            while (!journal.wants_checkpoint(1e9 * static_cast<double>(next + 1)))
                std::this_thread::sleep_for(std::chrono::milliseconds(1));
            journal.write_checkpoint(painting.state(), 1e9 * static_cast<double>(next));
        }
        journal.note_tick(painting.tick());
        if (painting.tick() >= recording.end_tick) return journal.folder();
        painting.advance_tick();
    }
}

inline std::uint64_t hash_of_replay(const document::Recording& recording, core::ThreadPool& pool) {
    document::Painting painting(recording.canvas, pool);
    document::Player player(painting, recording);
    while (!player.finished())
        player.play_tick();
    return painting.state_hash();
}

}  // namespace pastoso::journal
