// A painting that lives on its own thread: the window posts what the painter does and shows what is
// published. Nothing here knows of widgets.
#pragma once

#include "core/thread.hpp"
#include "core/thread_pool.hpp"
#include "document/events.hpp"
#include "document/painting.hpp"
#include "document/painting_state.hpp"
#include "document/recorder.hpp"
#include "journal/journal_writer.hpp"
#include "session/frame_times.hpp"
#include "session/tick_clock.hpp"

#include <atomic>
#include <condition_variable>
#include <deque>
#include <filesystem>
#include <functional>
#include <future>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

namespace pastoso::session {

inline constexpr double kMostSpeed = 20.0;

/// How the painting is doing, for the status bar and the state of the buttons.
struct Status {
    std::int64_t tick = 0;
    std::int64_t steps = 0;       ///< of the solver, in all
    std::int64_t strokes = 0;     ///< begun so far, those taken back included
    std::int64_t changes = 0;     ///< of the painting by the painter: strokes, dry_now, undo ...
    int awake_tiles = 0;          ///< tiles whose paint still moves
    double speed = 1.0;           ///< paint time over wall time, as it is wanted at this moment
    double paint_per_wall = 1.0;  ///< as it is: `speed` when the solver keeps up
    double load = 0.0;            ///< of the solver: TickClock::load()
    bool paused = false;
    bool failed = false;  ///< it is paused because a tick or its picture failed
    bool can_undo = false;
    bool can_redo = false;
    bool stroke_in_progress = false;
    bool replaying = false;  ///< a recording that was handed to play() has not ended yet
    friend bool operator==(const Status&, const Status&) = default;
};

/// What Undo would take back, the oldest first, and what Redo would do again, the next one last.
struct Steps {
    std::vector<document::KeptStep> past, future;
};

/// A painting between two strokes, with all that was done to it.
struct Capture {
    document::PaintingState painting;
    document::Recorder record;
    std::int64_t changes = 0;          ///< Status::changes at that moment
    std::uint64_t journal_events = 0;  ///< actions in the journal until then
};

/// Owns a Painting on a thread of its own. Actions are applied in the order of post(), each between two
/// ticks; pen samples never wait for more than the tick that is being computed. The painter's whole
/// session is recorded, so that it can be replayed to the same bits.
class PaintSession {
  public:
    using Notify = std::function<void()>;

    /// Makes a journal that begins as the session did, on the session's thread. Throws where that cannot
    /// be yet.
    using BeginJournal = std::function<std::unique_ptr<journal::JournalWriter>()>;

    /// Takes over a painting that has just been made with `pool`; the pool is the session's alone from
    /// now on. `past` is what was done to the painting before, up to its tick; `paused` as in
    /// set_paused(). `notify` is called on the session's thread after every publication and every error;
    /// it must return at once and must not call back into the session. What is painted goes to
    /// `journal`, where there is one; it stays to be recovered unless discard_journal() was called.
    /// Where there is none yet, `begin_journal` is asked for it every other second; it gets all that was
    /// painted until then.
    PaintSession(std::unique_ptr<core::ThreadPool> pool, std::unique_ptr<document::Painting> painting,
                 Notify notify, document::Recording past = {}, bool paused = false,
                 std::unique_ptr<journal::JournalWriter> journal = {}, BeginJournal begin_journal = {});
    ~PaintSession();
    PaintSession(const PaintSession&) = delete;
    PaintSession& operator=(const PaintSession&) = delete;

    /// Returns its number; the first action's is 1. It is in a snapshot of as many posted_actions.
    std::uint64_t post(document::Action action);

    /// What the next ResizeCanvas that is posted asks for (document::Painting::have_ready()).
    void have_ready(document::ResizedCanvas canvas);

    /// The brush has moved over the canvas. Where the paint is so slow that a tick would hold up the
    /// brush, it waits until the hand rests.
    void note_hand();

    /// Applies the events of a recording when their ticks come, the present tick being its tick 0.
    /// `hurried`: until the last one, ticks pass as fast as they are computed, and no steps to return to
    /// are kept, unless the recording returns to them itself: they would come faster than they can be
    /// packed, and fill the memory.
    void play(const std::vector<document::Event>& events, bool hurried = false);

    /// Stops paint time; the brush goes on working.
    void set_paused(bool paused);

    /// Lets paint time pass so many times faster than the clock on the wall, 1 to kMostSpeed, as far as
    /// the solver keeps up. Nothing of it is recorded: ticks come sooner, and are the same. While the
    /// painter's own stroke is under way time passes as usual, so that the hand meets the paint that it
    /// knows.
    void set_speed(double speed);

    /// Memory for what Undo returns to (document::Painting::set_history_budget()).
    void set_history_budget(std::size_t bytes);

    /// From now on `times` is told how long what is posted takes.
    void measure(std::shared_ptr<FrameTimes> times);

    /// The latest published state: never null, safe to read on any thread for as long as it is held.
    std::shared_ptr<const document::Snapshot> snapshot() const;
    Status status() const;
    std::shared_ptr<const Steps> steps() const;  ///< never null

    /// The sentences of actions that were refused since the last call, and of what failed. Where a tick
    /// or its picture failed, paint time has stopped.
    std::vector<core::Message> take_errors();

    /// Everything that was done so far.
    document::Recording recording() const { return record().recording(); }
    /// The same, packed: it can be unpacked where it keeps nobody waiting.
    document::Recorder record() const;

    /// The names of all paints that came out of their tubes so far (document/paint_reading.hpp).
    std::vector<std::string> paints_used() const;

    /// The painting as it is now, to be saved; a stroke in progress ends. Waits until all posted actions
    /// are applied. Throws core::InputError where it cannot be taken.
    Capture capture();

    /// Waits until all posted actions are applied and published.
    void wait_until_applied();

    /// Whether what is painted is kept to be recovered.
    bool has_journal() const;

    /// The painter has the painting of that capture in a file.
    void note_saved(const std::filesystem::path& path, std::uint64_t journal_events);

    /// The session ends and nothing of it needs to be recovered.
    void discard_journal();

    /// As published.
    document::CanvasSettings canvas() const { return snapshot()->bare->settings; }

  private:
    void run();
    void work();
    void do_action(const document::Action& action);
    std::int64_t changes() const;  ///< Status::changes at this moment
    void stop_at_fault(const core::Message& sentence);
    bool wait_for_work();
    void apply_posted();
    bool replay_waits() const;
    void begin_coming_replay();
    void apply_due_replay();
    void apply(const document::Action& action);
    bool advance_if_due();
    bool pass_tick(const std::function<bool()>& cancelled);
    void pass_rest();
    void note_rest();
    bool take_changed_steps();
    void publish();
    bool may_wait() const;
    double speed_now() const;
    void hand_out_capture();
    void apply_budget();
    void keep_journal();
    void try_to_begin_journal();
    std::uint64_t journal_events() const;
    void measure_quiet_tick(WallClock::time_point begin) const;
    void measure_publication(const document::Snapshot* snapshot) const;

    Notify notify_;

    // Of the session's thread alone.
    std::unique_ptr<core::ThreadPool> pool_;
    std::unique_ptr<document::Painting> painting_;
    std::unique_ptr<journal::JournalWriter> journal_;  ///< changed under the lock
    BeginJournal begin_journal_;                       ///< as long as there is no journal
    std::vector<document::Event> unkept_;              ///< what that is to begin with
    WallClock::time_point journal_tried_;
    TickClock clock_;
    std::int64_t strokes_ = 0;
    std::int64_t changes_ = 0;  ///< but for strokes that began beside the canvas
    bool at_rest_ = false;  ///< nothing happens but that time passes
    bool changed_ = false;
    bool steps_changed_ = false;
    std::int64_t late_strokes_ = 0;  ///< of the painting, when its steps were published last
    bool hurries_ = false;
    bool needs_no_steps_ = false, keeps_no_steps_ = false;  ///< to return to
    std::optional<std::size_t> budget_bytes_;  ///< for steps, where it is not the painting's own
    WallClock::time_point published_at_;

    mutable std::mutex mutex_;
    std::condition_variable work_;
    std::condition_variable published_;
    std::deque<document::Action> posted_;
    std::optional<document::ResizedCanvas> ready_canvas_;
    std::vector<document::Event> coming_replay_;  ///< by ticks of its own
    std::deque<document::Event> replay_;
    std::shared_ptr<FrameTimes> times_;
    bool replay_is_hurried_ = false;
    bool replay_undoes_ = false;
    std::vector<core::Message> errors_;
    std::vector<std::string> paints_used_;
    document::Recorder recorder_;
    std::shared_ptr<const document::Snapshot> snapshot_;
    Status status_;
    std::shared_ptr<const Steps> steps_ = std::make_shared<Steps>();
    WallClock::time_point hand_moved_;
    std::atomic<bool> action_waits_ = false;  ///< asked in the middle of a tick
    std::promise<Capture>* wanted_capture_ = nullptr;
    struct Saved {
        std::filesystem::path path;
        std::uint64_t journal_events = 0;
    };
    std::optional<Saved> saved_before_journal_;
    bool journal_discarded_ = false;
    std::optional<std::size_t> wanted_budget_bytes_;
    std::uint64_t posted_count_ = 0;
    std::uint64_t applied_count_ = 0;
    std::uint64_t published_count_ = 0;  ///< of the posted actions, those that a publication shows
    double speed_ = 1.0;
    bool paused_ = false, failed_ = false;
    bool stopping_ = false;

    core::Thread thread_;
};

}  // namespace pastoso::session
