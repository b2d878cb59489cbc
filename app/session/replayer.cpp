#include "session/replayer.hpp"

#include "journal/undo_reach.hpp"
#include "recordings/canvas_support.hpp"

#include <algorithm>
#include <utility>

namespace pastoso::session {
namespace {

constexpr auto kBetweenPictures = std::chrono::milliseconds(25);

/// Later than this it stays late: a debt of ticks is dropped, as TickClock does.
constexpr auto kMostDelay = std::chrono::milliseconds(100);

/// States that are kept of a recording, and the least time between two.
constexpr std::int64_t kStates = 8, kLeastApart_ticks = 300;

std::chrono::steady_clock::duration tick_length(double speed) {
    return std::chrono::duration_cast<std::chrono::steady_clock::duration>(
        std::chrono::duration<double>(document::kTick_s / speed));
}

}  // namespace

Replayer::Replayer(document::Recording recording, Notify notify)
    : recording_(std::move(recording)), notify_(std::move(notify)) {
    status_.end_tick = recording_.end_tick;
    status_.playing = true;
    thread_ = core::Thread([this] { run(); }, [this](const core::Message& fault) { fail(fault); });
}

Replayer::~Replayer() {
    {
        const std::lock_guard lock(mutex_);
        stopping_ = true;
    }
    changed_.notify_all();
    thread_.join();
}

void Replayer::set_playing(bool playing) {
    {
        const std::lock_guard lock(mutex_);
        if (playing && status_.tick >= status_.end_tick && !target_) target_ = 0;
        status_.playing = playing;
        due_ = Clock::now();
    }
    changed_.notify_all();
}

void Replayer::set_speed(double speed) {
    {
        const std::lock_guard lock(mutex_);
        speed_ = speed;
        due_ = Clock::now();
    }
    changed_.notify_all();
}

void Replayer::seek(std::int64_t tick) {
    {
        const std::lock_guard lock(mutex_);
        target_ = std::clamp<std::int64_t>(tick, 0, status_.end_tick);
        status_.seeking = true;
    }
    changed_.notify_all();
}

std::shared_ptr<const document::Snapshot> Replayer::snapshot() const {
    const std::lock_guard lock(mutex_);
    return snapshot_;
}

Replayer::Status Replayer::status() const {
    const std::lock_guard lock(mutex_);
    return status_;
}

void Replayer::run() {
    begin(0);
    publish();
    while (wait_for_work())
        step();
}

/// It cannot go on.
void Replayer::fail(const core::Message& sentence) {
    {
        const std::lock_guard lock(mutex_);
        status_.error = sentence;
        status_.playing = status_.seeking = false;
    }
    notify_();
}

/// False: it is over.
bool Replayer::wait_for_work() {
    std::unique_lock lock(mutex_);
    while (!stopping_ && !target_) {
        if (!status_.playing)
            changed_.wait(lock);
        else if (speed_ == kFullSpeed || Clock::now() >= due_)
            break;
        else
            changed_.wait_until(lock, due_);
    }
    return !stopping_;
}

/// A tick, or what is left to do where it was sent.
void Replayer::step() {
    std::optional<std::int64_t> target;
    {
        const std::lock_guard lock(mutex_);
        target = target_;
    }
    if (target && *target < painting_->tick()) begin(*target);
    if (target && is_there(*target)) return arrive(*target);
    if (player_->finished()) return end();
    play_tick();
    if (player_->finished() && !target) return end();
    publish_if_due();
}

/// The end is there when what was done in its tick is, too.
bool Replayer::is_there(std::int64_t tick) const {
    return player_->finished() || (tick < recording_.end_tick && painting_->tick() >= tick);
}

void Replayer::play_tick() {
    keep_state();
    player_->play_tick();
    const std::lock_guard lock(mutex_);
    if (speed_ != kFullSpeed) due_ = std::max(due_ + tick_length(speed_), Clock::now() - kMostDelay);
}

void Replayer::arrive(std::int64_t tick) {
    publish([this, tick] {
        if (target_ == tick) target_.reset();
        status_.seeking = target_.has_value();
        due_ = Clock::now();
    });
}

void Replayer::end() {
    publish([this] { status_.playing = false; });
}

/// From the start, or from the latest state kept before that tick.
void Replayer::begin(std::int64_t tick) {
    const Kept* kept = kept_before(tick);
    const std::size_t next_event = kept != nullptr ? kept->next_event : 0;
    player_.reset();
    painting_ = kept != nullptr ? std::make_unique<document::Painting>(kept->state, pool_)
                                : recordings::make_painting(recording_.canvas, pool_);
    rest_ = {recording_.canvas, {}, recording_.end_tick};
    rest_.events.assign(recording_.events.begin() + static_cast<std::ptrdiff_t>(next_event),
                        recording_.events.end());
    painting_->keep_undo_steps(document::undo_depth(rest_));
    player_ = std::make_unique<document::Player>(*painting_, rest_);
}

/// None that an Undo after it reaches behind: such a state has no past.
const Replayer::Kept* Replayer::kept_before(std::int64_t tick) const {
    for (auto kept = kept_.rbegin(); kept != kept_.rend(); ++kept) {
        if (kept->state.tick > tick) continue;
        journal::UndoReach reach;
        for (std::size_t i = kept->next_event; i < recording_.events.size(); ++i)
            reach.note(recording_.events[i].action);
        if (!reach.crossed()) return &*kept;
    }
    return nullptr;
}

/// Between strokes, every now and then.
void Replayer::keep_state() {
    const std::int64_t tick = painting_->tick();
    const std::int64_t apart = std::max(kLeastApart_ticks, recording_.end_tick / kStates);
    const std::int64_t latest = kept_.empty() ? 0 : kept_.back().state.tick;
    if (tick < latest + apart || painting_->stroke_in_progress()) return;
    const auto next = std::lower_bound(
        recording_.events.begin(), recording_.events.end(), tick,
        [](const document::Event& event, std::int64_t before) { return event.tick < before; });
    kept_.push_back({painting_->state(), static_cast<std::size_t>(next - recording_.events.begin())});
}

void Replayer::publish_if_due() {
    if (Clock::now() - published_at_ >= kBetweenPictures) publish();
}

/// What is said of the moment changes together with its picture.
void Replayer::publish(const std::function<void()>& settle) {
    auto snapshot = std::make_shared<const document::Snapshot>(painting_->snapshot());
    {
        const std::lock_guard lock(mutex_);
        status_.tick = snapshot->tick;
        snapshot_ = std::move(snapshot);
        settle();
    }
    published_at_ = Clock::now();
    notify_();
}

}  // namespace pastoso::session
