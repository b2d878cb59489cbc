#include "session/paint_session.hpp"

#include "core/check.hpp"
#include "core/error.hpp"
#include "document/history.hpp"
#include "document/paint_reading.hpp"
#include "pigment/paint_name.hpp"

#include <algorithm>
#include <utility>

namespace pastoso::session {
namespace {

/// Posted actions are applied for at most this long before the paint gets its tick and the screen its
/// picture.
constexpr auto kLongestBatch = std::chrono::milliseconds(8);

/// From one attempt to begin a journal to the next.
constexpr auto kJournalPause = std::chrono::seconds(2);

bool is_known(const std::string& paint) {
    try {
        pigment::check_paint_name(paint);
        return true;
    } catch (const core::InputError&) {
        return false;
    }
}

/// What came out of the tubes in a past, but for paints of another painter that are not known here.
std::vector<std::string> known_paints(const document::Recording& past) {
    std::vector<std::string> names;
    for (const document::Event& event : past.events)
        document::note_paints(event.action, names);
    std::erase_if(names, [](const std::string& name) { return !is_known(name); });
    return names;
}

/// The paint gives way to the window, and to a graphics driver that is software; not so much that other
/// programs bring it to a stand.
constexpr int kNice = 3;

/// Paint at rest is looked after so often.
constexpr auto kRest = std::chrono::seconds(3);

/// Until the painting's present tick; of a new painting, nothing.
document::Recording past_of(const document::Painting& painting, document::Recording past) {
    if (past.events.empty()) past = {.canvas = painting.settings(), .events = {}};
    past.end_tick = painting.tick();
    return past;
}

}  // namespace

PaintSession::PaintSession(std::unique_ptr<core::ThreadPool> pool,
                           std::unique_ptr<document::Painting> painting, Notify notify,
                           document::Recording past, bool paused,
                           std::unique_ptr<journal::JournalWriter> journal, BeginJournal begin_journal)
    : notify_(std::move(notify)),
      pool_(std::move(pool)),
      painting_(std::move(painting)),
      journal_(std::move(journal)),
      begin_journal_(journal_ ? BeginJournal() : std::move(begin_journal)),
      journal_tried_(WallClock::now()),
      clock_(WallClock::now()),
      paints_used_(known_paints(past)),
      recorder_(past_of(*painting_, std::move(past))) {
    paused_ = status_.paused = paused;
    status_.tick = painting_->tick();
    snapshot_ = std::make_shared<const document::Snapshot>(painting_->snapshot());
    thread_ =
        core::Thread([this] { run(); }, [this](const core::Message& fault) { stop_at_fault(fault); });
}

PaintSession::~PaintSession() {
    {
        const std::lock_guard lock(mutex_);
        stopping_ = true;
        action_waits_ = true;
    }
    work_.notify_all();
    thread_.join();
}

std::uint64_t PaintSession::post(document::Action action) {
    std::uint64_t number = 0;
    {
        const std::lock_guard lock(mutex_);
        posted_.push_back(std::move(action));
        number = ++posted_count_;
        if (times_) times_->posted(WallClock::now());
        action_waits_ = true;
    }
    work_.notify_all();
    return number;
}

void PaintSession::have_ready(document::ResizedCanvas canvas) {
    const std::lock_guard lock(mutex_);
    ready_canvas_ = std::move(canvas);
}

void PaintSession::note_hand() {
    const std::lock_guard lock(mutex_);
    hand_moved_ = WallClock::now();
}

void PaintSession::play(const std::vector<document::Event>& events, bool hurried) {
    {
        const std::lock_guard lock(mutex_);
        replay_is_hurried_ = hurried;
        replay_undoes_ = std::any_of(events.begin(), events.end(), [](const document::Event& event) {
            return std::holds_alternative<document::Undo>(event.action);
        });
        coming_replay_.insert(coming_replay_.end(), events.begin(), events.end());
        status_.replaying = replay_waits();
    }
    work_.notify_all();
}

void PaintSession::set_paused(bool paused) {
    {
        const std::lock_guard lock(mutex_);
        paused_ = status_.paused = paused;
        failed_ = status_.failed = false;
    }
    work_.notify_all();
}

void PaintSession::set_speed(double speed) {
    PASTOSO_CHECK(speed >= 1.0 && speed <= kMostSpeed);
    {
        const std::lock_guard lock(mutex_);
        speed_ = speed;
    }
    work_.notify_all();
}

void PaintSession::set_history_budget(std::size_t bytes) {
    {
        const std::lock_guard lock(mutex_);
        wanted_budget_bytes_ = bytes;
    }
    work_.notify_all();
}

void PaintSession::apply_budget() {
    std::optional<std::size_t> bytes;
    {
        const std::lock_guard lock(mutex_);
        bytes = std::exchange(wanted_budget_bytes_, std::nullopt);
    }
    if (bytes) budget_bytes_ = bytes;
    if (!bytes && needs_no_steps_ == keeps_no_steps_) return;
    keeps_no_steps_ = needs_no_steps_;
    painting_->set_history_budget(
        keeps_no_steps_ ? 0 : budget_bytes_.value_or(document::History::kDefaultBudget_bytes));
    changed_ = steps_changed_ = true;
}

void PaintSession::measure(std::shared_ptr<FrameTimes> times) {
    const std::lock_guard lock(mutex_);
    times_ = std::move(times);
}

void PaintSession::measure_quiet_tick(WallClock::time_point begin) const {
    const std::lock_guard lock(mutex_);
    const bool quiet = posted_.empty() && painting_->film_report().awake_tiles == 0;
    if (times_ && quiet)
        times_->quiet_tick(std::chrono::duration<double>(WallClock::now() - begin).count());
}

/// The lock is held.
void PaintSession::measure_publication(const document::Snapshot* snapshot) const {
    if (times_) times_->published(applied_count_ - published_count_, snapshot, WallClock::now());
}

std::shared_ptr<const document::Snapshot> PaintSession::snapshot() const {
    const std::lock_guard lock(mutex_);
    return snapshot_;
}

std::shared_ptr<const Steps> PaintSession::steps() const {
    const std::lock_guard lock(mutex_);
    return steps_;
}

Status PaintSession::status() const {
    const std::lock_guard lock(mutex_);
    return status_;
}

std::vector<core::Message> PaintSession::take_errors() {
    const std::lock_guard lock(mutex_);
    return std::exchange(errors_, {});
}

document::Recorder PaintSession::record() const {
    const std::lock_guard lock(mutex_);
    return recorder_;
}

std::vector<std::string> PaintSession::paints_used() const {
    const std::lock_guard lock(mutex_);
    return paints_used_;
}

Capture PaintSession::capture() {
    std::promise<Capture> promise;
    {
        const std::lock_guard lock(mutex_);
        wanted_capture_ = &promise;
        action_waits_ = true;
    }
    work_.notify_all();
    return promise.get_future().get();
}

/// Once nothing that was posted before waits any more.
void PaintSession::hand_out_capture() {
    {
        const std::lock_guard lock(mutex_);
        if (wanted_capture_ == nullptr || !posted_.empty()) return;
    }
    if (painting_->stroke_in_progress()) apply(document::PenUp{});
    document::PaintingState state = painting_->state();
    const std::lock_guard lock(mutex_);
    recorder_.note_tick(painting_->tick());
    std::exchange(wanted_capture_, nullptr)
        ->set_value({std::move(state), recorder_, changes(), journal_events()});
}

std::uint64_t PaintSession::journal_events() const {
    return journal_ ? journal_->events() : unkept_.size();
}

bool PaintSession::has_journal() const {
    const std::lock_guard lock(mutex_);
    return journal_ != nullptr;
}

void PaintSession::note_saved(const std::filesystem::path& path, std::uint64_t journal_events) {
    const std::lock_guard lock(mutex_);
    if (journal_)
        journal_->note_saved(path, journal_events);
    else
        saved_before_journal_ = Saved{path, journal_events};
}

void PaintSession::discard_journal() {
    const std::lock_guard lock(mutex_);
    journal_discarded_ = true;
    if (journal_) journal_->discard();
}

void PaintSession::wait_until_applied() {
    std::unique_lock lock(mutex_);
    const std::uint64_t wanted = posted_count_;
    published_.wait(lock, [&] { return published_count_ >= wanted; });
}

void PaintSession::run() {
    core::lower_priority(kNice);
    pool_->lower_priority(kNice);
    while (wait_for_work())
        core::guarded([this] { work(); }, [this](const core::Message& fault) { stop_at_fault(fault); });
}

void PaintSession::work() {
    apply_budget();
    if (at_rest_) pass_rest();
    apply_posted();
    apply_due_replay();
    hand_out_capture();
    const auto begin = WallClock::now();
    const bool ticked = advance_if_due();
    if (begin_journal_) try_to_begin_journal();
    if (journal_) keep_journal();
    if (changed_ && !may_wait()) publish();
    if (ticked) measure_quiet_tick(begin);
    note_rest();
}

/// The ticks of paint at rest are not waited for one by one: they are passed together, before anything
/// else happens.
void PaintSession::pass_rest() {
    const auto now = WallClock::now();
    while (clock_.due(now) && painting_->film_report().awake_tiles == 0) {
        const auto due = clock_.next(), begin = WallClock::now();
        pass_tick([] { return false; });
        clock_.tick_ended(due, due, true);
        measure_quiet_tick(begin);
    }
}

void PaintSession::note_rest() {
    const std::lock_guard lock(mutex_);
    at_rest_ = !paused_ && speed_ == 1.0 && !replay_waits() && !painting_->stroke_in_progress() &&
               painting_->film_report().awake_tiles == 0;
}

/// What fails once would fail again with every tick. Whoever waits has waited long enough.
void PaintSession::stop_at_fault(const core::Message& sentence) {
    {
        const std::lock_guard lock(mutex_);
        errors_.push_back(sentence);
        paused_ = status_.paused = failed_ = status_.failed = true;
        published_count_ = applied_count_;
        if (wanted_capture_ != nullptr)
            std::exchange(wanted_capture_, nullptr)
                ->set_exception(std::make_exception_ptr(core::InputError(sentence)));
    }
    published_.notify_all();
    if (notify_) notify_();
}

/// Time that is faster, and a hurried replay, show no more pictures than a screen does.
bool PaintSession::may_wait() const {
    constexpr auto kScreenPeriod = std::chrono::milliseconds(16);
    if (published_count_ != applied_count_) return false;
    const std::lock_guard lock(mutex_);
    const bool fast = speed_ > 1.0 || (hurries_ && replay_waits());
    return fast && !paused_ && WallClock::now() - published_at_ < kScreenPeriod;
}

/// The lock is held.
double PaintSession::speed_now() const {
    return painting_->stroke_in_progress() && !replay_waits() ? 1.0 : speed_;
}

/// Sleeps until there is an action, a tick is due or the session ends; false at the end.
bool PaintSession::wait_for_work() {
    std::unique_lock lock(mutex_);
    const auto ready = [&] {
        return stopping_ || !posted_.empty() || wanted_capture_ != nullptr || wanted_budget_bytes_;
    };
    if (paused_) {
        const auto wakes = [&] { return ready() || !paused_ || (changed_ && !failed_); };
        if (begin_journal_)
            work_.wait_for(lock, kJournalPause, wakes);
        else
            work_.wait(lock, wakes);
        if (!paused_) clock_.restart(WallClock::now());
    } else {
        const auto wakes = [&] {
            return ready() || paused_ || (at_rest_ && (replay_waits() || speed_ != 1.0));
        };
        work_.wait_until(lock, clock_.next() + (at_rest_ ? kRest : WallClock::duration::zero()), wakes);
    }
    clock_.hand_moved(hand_moved_);
    hurries_ = replay_is_hurried_ && replay_waits();
    needs_no_steps_ = hurries_ && !replay_undoes_;
    clock_.set_hurried(hurries_);
    clock_.set_speed(speed_now());
    return !stopping_;
}

void PaintSession::apply_posted() {
    const auto deadline = WallClock::now() + kLongestBatch;
    do {
        document::Action action;
        {
            const std::lock_guard lock(mutex_);
            if (posted_.empty()) return;
            action = std::move(posted_.front());
            posted_.pop_front();
            if (ready_canvas_ && std::holds_alternative<document::ResizeCanvas>(action))
                painting_->have_ready(*std::exchange(ready_canvas_, std::nullopt));
            action_waits_ = !posted_.empty();
            ++applied_count_;
        }
        apply(action);
    } while (WallClock::now() < deadline);
}

/// The lock is held.
bool PaintSession::replay_waits() const {
    return !replay_.empty() || !coming_replay_.empty();
}

/// Its tick 0 is the painting's present one, whatever was published last.
void PaintSession::begin_coming_replay() {
    const std::lock_guard lock(mutex_);
    for (document::Event& event : coming_replay_) {
        event.tick += painting_->tick();
        replay_.push_back(std::move(event));
    }
    coming_replay_.clear();
}

void PaintSession::apply_due_replay() {
    begin_coming_replay();
    while (true) {
        document::Action action;
        {
            const std::lock_guard lock(mutex_);
            if (replay_.empty() || replay_.front().tick > painting_->tick()) return;
            action = std::move(replay_.front().action);
            replay_.pop_front();
        }
        apply(action);
    }
}

/// Undo or Redo with nothing to return to is not recorded: replayed after the painting's past, it would
/// find something.
void PaintSession::apply(const document::Action& action) {
    changed_ = true;
    steps_changed_ = steps_changed_ || !std::holds_alternative<document::PenMove>(action);
    const bool undoes_nothing = std::holds_alternative<document::Undo>(action) && !painting_->can_undo();
    const bool redoes_nothing = std::holds_alternative<document::Redo>(action) && !painting_->can_redo();
    if (undoes_nothing || redoes_nothing) {
        if (painting_->stroke_in_progress()) apply(document::PenUp{});
        return;
    }
    core::guarded([&] { do_action(action); },
                  [this](const core::Message& fault) {
                      const std::lock_guard lock(mutex_);
                      errors_.push_back(fault);
                  });
}

void PaintSession::do_action(const document::Action& action) {
    painting_->apply(action);
    strokes_ += std::holds_alternative<document::PenDown>(action) ? 1 : 0;
    changes_ += document::counts_as_change(action) ? 1 : 0;
    if (journal_) journal_->note({painting_->tick(), action});
    if (begin_journal_) unkept_.push_back({painting_->tick(), action});
    const std::lock_guard lock(mutex_);
    recorder_.add(painting_->tick(), action);
    document::note_paints(action, paints_used_);
}

std::int64_t PaintSession::changes() const {
    return changes_ + painting_->late_strokes();
}

void PaintSession::try_to_begin_journal() {
    if (WallClock::now() - journal_tried_ < kJournalPause) return;
    journal_tried_ = WallClock::now();
    std::unique_ptr<journal::JournalWriter> journal;
    // Whoever gave no journal has told why; that holds on.
    if (!core::fault_of([&] { journal = begin_journal_(); }).empty()) return;
    for (const document::Event& event : std::exchange(unkept_, {}))
        journal->note(event);
    begin_journal_ = {};
    const std::lock_guard lock(mutex_);
    if (saved_before_journal_)
        journal->note_saved(saved_before_journal_->path, saved_before_journal_->journal_events);
    if (journal_discarded_) journal->discard();
    journal_ = std::move(journal);
}

void PaintSession::keep_journal() {
    journal_->note_tick(painting_->tick(), painting_->film_report().awake_tiles > 0);
    const document::StageTimes times = painting_->stage_times();
    const double work_s = times.brush_s + times.film_s;
    if (!painting_->stroke_in_progress() && journal_->wants_checkpoint(work_s))
        journal_->write_checkpoint(painting_->state(), work_s);
}

/// Whether a tick was due.
bool PaintSession::advance_if_due() {
    {
        const std::lock_guard lock(mutex_);
        if (paused_) return false;
    }
    const auto begin = WallClock::now();
    if (!clock_.due(begin)) return false;
    const bool passed =
        pass_tick([&] { return action_waits_ && WallClock::now() - begin > kFeltDelay; });
    clock_.tick_ended(begin, WallClock::now(), passed);
    return true;
}

/// False where it was cancelled.
bool PaintSession::pass_tick(const std::function<bool()>& cancelled) {
    const std::int64_t cells_before = painting_->film_report().cells_stepped;
    const bool passed = painting_->advance_tick_unless(cancelled);
    // Ticks of paint at rest change nothing that anybody sees but that it dries.
    constexpr std::int64_t kQuietTicks = 180;
    changed_ = changed_ || painting_->film_report().cells_stepped != cells_before ||
               painting_->late_strokes() != late_strokes_ ||
               painting_->tick() % kQuietTicks == 0;
    return passed;
}

/// Whether steps have come or gone since they were asked for last. A stroke that began beside becomes one
/// while the pen moves, or blows, on.
bool PaintSession::take_changed_steps() {
    const std::int64_t late = painting_->late_strokes();
    const bool came_late = std::exchange(late_strokes_, late) != late;
    return std::exchange(steps_changed_, false) || came_late;
}

void PaintSession::publish() {
    document::Snapshot taken = painting_->snapshot();
    taken.posted_actions = applied_count_;
    auto snapshot = std::make_shared<const document::Snapshot>(std::move(taken));
    const film::AdvanceReport report = painting_->film_report();
    std::shared_ptr<const Steps> steps;
    if (take_changed_steps())
        steps = std::make_shared<const Steps>(Steps{painting_->undo_steps(), painting_->redo_steps()});
    {
        const std::lock_guard lock(mutex_);
        if (steps) steps_ = std::move(steps);
        snapshot_.swap(snapshot);
        measure_publication(snapshot_.get());
        recorder_.note_tick(painting_->tick());
        status_ = {.tick = painting_->tick(),
                   .steps = report.steps,
                   .strokes = strokes_,
                   .changes = changes(),
                   .awake_tiles = report.awake_tiles,
                   .speed = clock_.speed(),
                   .paint_per_wall = clock_.paint_per_wall(),
                   .load = clock_.load(),
                   .paused = paused_,
                   .failed = failed_,
                   .can_undo = painting_->can_undo(),
                   .can_redo = painting_->can_redo(),
                   .stroke_in_progress = painting_->stroke_in_progress(),
                   .replaying = replay_waits()};
    }
    changed_ = false;
    published_at_ = WallClock::now();
    if (notify_) notify_();
    // Whoever waits for the publication finds it announced.
    {
        const std::lock_guard lock(mutex_);
        published_count_ = applied_count_;
    }
    published_.notify_all();
}

}  // namespace pastoso::session
