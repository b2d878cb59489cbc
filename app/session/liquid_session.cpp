#include "session/liquid_session.hpp"

#include "core/check.hpp"

#include <algorithm>
#include <utility>

namespace pastoso::session {

LiquidSession::LiquidSession(bool paused, Notify notify) : notify_(std::move(notify)), paused_(paused) {
    status_.paused = paused;
}

LiquidSession::~LiquidSession() {
    PASTOSO_CHECK(!thread_.exists());
}

void LiquidSession::begin() {
    thread_ =
        core::Thread([this] { run(); }, [this](const core::Message& fault) { stop_at_fault(fault); });
}

void LiquidSession::end() {
    {
        const std::lock_guard lock(mutex_);
        stopping_ = true;
    }
    work_.notify_all();
    thread_.join();
}

void LiquidSession::post(Action action) {
    {
        const std::lock_guard lock(mutex_);
        status_.busy = status_.busy || action.makes_glass;
        posted_.push_back(std::move(action));
        ++posted_count_;
    }
    work_.notify_all();
}

std::vector<core::Message> LiquidSession::take_errors() {
    const std::lock_guard lock(mutex_);
    return std::exchange(errors_, {});
}

void LiquidSession::wait_until_applied() {
    std::unique_lock lock(mutex_);
    const std::uint64_t wanted = posted_count_;
    published_.wait(lock, [&] { return published_count_ >= wanted; });
}

void LiquidSession::set_paused(bool paused) {
    post({[this, paused] {
        paused_ = paused;
        if (!paused_) shown_step_.reset();
        due_ = stepped_at_ = Clock::now();
    }});
}

void LiquidSession::set_full_speed(bool full) {
    post({[this, full] {
        full_speed_ = full;
        due_ = Clock::now();
    }});
}

void LiquidSession::advance(int steps) {
    post({[this, steps] {
        if (!has_liquid()) return;
        shown_step_.reset();
        paused_ = true;
        const int last = last_step() + steps;
        while (last_step() < last && !waits() && !is_ending())
            step_liquid();
    }});
}

bool LiquidSession::is_ending() const {
    const std::lock_guard lock(mutex_);
    return stopping_;
}

void LiquidSession::show(int step) {
    post({[this, step] {
        if (!has_liquid()) return;
        paused_ = true;
        shown_step_ = step;
        if (step >= last_step()) shown_step_.reset();
    }});
}

void LiquidSession::glass_made() {
    shown_step_.reset();
    ++glass_;
    steps_per_s_ = 0.0;
    due_ = stepped_at_ = Clock::now();
}

void LiquidSession::run() {
    while (wait_for_work())
        core::guarded([this] { work(); }, [this](const core::Message& fault) { stop_at_fault(fault); });
}

void LiquidSession::work() {
    while (apply_next()) {
    }
    if (runs() && (full_speed_ || Clock::now() >= due_)) step();
    if (changed_ && !may_wait()) publish();
}

void LiquidSession::refuse(const core::Message& sentence) {
    const std::lock_guard lock(mutex_);
    errors_.push_back(sentence);
}

/// What fails once would fail again with every step. Whoever waits has waited long enough.
void LiquidSession::stop_at_fault(const core::Message& sentence) {
    refuse(sentence);
    paused_ = true;
    {
        const std::lock_guard lock(mutex_);
        status_.paused = true;
        published_count_ = applied_count_;
    }
    published_.notify_all();
    if (notify_) notify_();
}

/// Sleeps until something is said, a step is due or the session ends; false at the end.
bool LiquidSession::wait_for_work() {
    std::unique_lock lock(mutex_);
    const auto ready = [&] { return stopping_ || !posted_.empty(); };
    if (!runs())
        work_.wait(lock, ready);
    else if (!full_speed_)
        work_.wait_until(lock, due_, ready);
    return !stopping_;
}

/// False when nothing is left to be applied before the next step.
bool LiquidSession::apply_next() {
    Action action;
    {
        const std::lock_guard lock(mutex_);
        if (posted_.empty()) return false;
        if (posted_.front().waits_for_step && owes_step() && runs()) return false;
        action = std::move(posted_.front());
        posted_.pop_front();
        ++applied_count_;
    }
    changed_ = true;
    core::guarded(action.apply, [this](const core::Message& fault) { refuse(fault); });
    return true;
}

/// A liquid that is too slow to compute runs late and stays late.
void LiquidSession::step() {
    constexpr double kNewestShare = 0.1;
    const double passed_s = step_liquid();
    changed_ = true;
    const auto now = Clock::now();
    const double took_s = std::chrono::duration<double>(now - stepped_at_).count();
    if (took_s > 0.0) steps_per_s_ += kNewestShare * (1.0 / took_s - steps_per_s_);
    stepped_at_ = now;
    const auto length =
        std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(passed_s));
    due_ = std::max(due_ + length, now - length);
}

/// While time passes, no more of it is spent on showing than on stepping, and no more pictures are made
/// than a screen shows.
bool LiquidSession::may_wait() const {
    constexpr auto kScreenPeriod = std::chrono::milliseconds(30);
    if (!runs() || applied_count_ != published_count_) return false;
    return Clock::now() - published_at_ <
           std::max<Clock::duration>(2 * publication_cost_,
                                     full_speed_ ? kScreenPeriod : kScreenPeriod / 2);
}

void LiquidSession::publish() {
    const auto begin = Clock::now();
    LiquidStatus status;
    if (has_liquid()) make_moment(status);
    status.glass = glass_;
    status.paused = paused_;
    status.full_speed = full_speed_;
    status.shows_last = !shown_step_;
    status.steps_per_s = paused_ ? 0.0 : steps_per_s_;
    {
        const std::lock_guard lock(mutex_);
        status.busy = std::any_of(posted_.begin(), posted_.end(),
                                  [](const Action& action) { return action.makes_glass; });
        status_ = std::move(status);
        give_moment();
    }
    changed_ = false;
    published_at_ = Clock::now();
    publication_cost_ = published_at_ - begin;
    if (notify_) notify_();
    {
        const std::lock_guard lock(mutex_);
        published_count_ = applied_count_;
    }
    published_.notify_all();
}

}  // namespace pastoso::session
