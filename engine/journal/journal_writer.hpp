// Keeps on the disk what is painted, as it happens.
#pragma once

#include "core/message.hpp"
#include "core/thread.hpp"
#include "document/events.hpp"
#include "document/painting_state.hpp"
#include "journal/checkpoint_writer.hpp"
#include "journal/journal_file.hpp"
#include "journal/journal_folder.hpp"
#include "journal/undo_reach.hpp"

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <mutex>
#include <string>
#include <vector>

namespace pastoso::journal {

/// The painting that a journal begins with.
struct Beginning {
    document::CanvasSettings canvas{};
    std::int64_t tick = 0;
    std::filesystem::path painting{};  ///< the project file that was opened; empty: a new painting
    /// Puts a project file of the painting, with its strokes, at this path; none: the bare canvas.
    std::function<void(const std::filesystem::path& path)> write_start{};
    bool is_saved = true;  ///< nothing of it is in the journal alone
};

/// How often something is written.
struct Pace {
    double flush_s = 0.25;  ///< from an action to its place in the file, at most
    /// A checkpoint is worth its work when a replay would take this long ...
    double replay_s = 3.0;
    /// ... or after this time, if anything was painted; and so many times longer than the last one took
    /// have passed since then.
    double idle_s = 60.0;
    double rests = 10.0;
    double retry_s = 2.0;  ///< from what could not be written to the next attempt
};

/// Why what is painted cannot be kept.
struct Trouble {
    core::Message reason{};           ///< a sentence; empty: all is kept again
    bool disk_is_full = false;        ///< that is the reason
    bool strokes_are_kept = false;    ///< only a checkpoint is not: a recovery takes longer
    std::uint64_t waiting_bytes = 0;  ///< of strokes, that are not in the file yet
};

/// The painting's thread notes what it does and never waits for the disk: two threads of the journal
/// write, one the actions, four times a second and flushed, the other checkpoints, at low priority.
class JournalWriter {
  public:
    /// Is told when trouble begins, changes or ends, on any of the journal's threads; must return at
    /// once and must not call back. The journal goes on trying.
    using Told = std::function<void(const Trouble& trouble)>;

    /// Makes the journal's folder in `root`, and its start. Throws InputError where that cannot be.
    JournalWriter(const std::filesystem::path& root, const Beginning& beginning, Pace pace = {},
                  Told told = {});

    /// Everything noted is written; the journal stays to be recovered, unless it was discarded.
    ~JournalWriter();
    JournalWriter(const JournalWriter&) = delete;
    JournalWriter& operator=(const JournalWriter&) = delete;

    const std::filesystem::path& folder() const { return claim_.folder(); }

    // Of the painting's thread.

    /// The action was applied; ticks do not decrease.
    void note(const document::Event& event);
    /// So many ticks have passed; where no paint moves, that is written less often.
    void note_tick(std::int64_t tick, bool paint_moves = true);
    /// How many actions were noted.
    std::uint64_t events() const { return events_; }
    /// Whether the state of the painting, between two strokes, should be given to write_checkpoint().
    /// `work_s` is how long painting has taken so far: a replay takes the same.
    bool wants_checkpoint(double work_s) const;
    void write_checkpoint(document::PaintingState state, double work_s);

    // Of any thread.

    /// After that many actions, the painting was saved there by the painter: it needs no recovery.
    void note_saved(const std::filesystem::path& path, std::uint64_t events);

    /// Nothing needs to be recovered: the journal goes when the writer does.
    void discard();

  private:
    using Clock = std::chrono::steady_clock;

    void run();
    bool time_is_due() const;
    void wait_for_more(std::unique_lock<std::mutex>& lock);
    void write_pending(std::unique_lock<std::mutex>& lock);
    std::string pending_frames(document::Recording batch, std::uint64_t first_event,
                               const std::vector<std::string>& frames) const;
    bool append(const std::string& bytes);
    void note_trouble(Trouble& of, Trouble now);
    void flush_start();
    Trouble write(const std::vector<document::Event>& events, std::int64_t tick,
                  const std::vector<std::string>& frames);

    const Pace pace_;
    const Told told_;
    Claim claim_;
    int file_ = -1;
    std::int64_t end_ = 0;  ///< of what is whole in the file
    bool torn_ = false;     ///< something stands behind it
    document::CanvasSettings canvas_;

    // Of the painting's thread.
    std::uint64_t events_ = 0;
    UndoReach since_checkpoint_;
    bool starts_bare_image_ = false;  ///< the canvas is made of a file that may go away
    bool painted_since_ = false;
    double work_at_checkpoint_s_ = 0.0;
    Clock::time_point checkpoint_at_;
    std::atomic<bool> checkpoint_failed_ = false;

    std::mutex mutex_;
    std::condition_variable wake_;
    std::vector<document::Event> pending_;
    std::vector<std::string> pending_frames_;  ///< of checkpoints and saves, after the actions
    std::uint64_t written_events_ = 0;         ///< and how many of them are in the file
    std::int64_t tick_ = 0, written_tick_ = 0;
    bool paint_moves_ = false;
    Trouble strokes_trouble_, checkpoint_trouble_;  ///< without a reason: none
    bool discarded_ = false;
    bool stopping_ = false;

    CheckpointWriter checkpoints_;
    core::Thread thread_;
};

}  // namespace pastoso::journal
