#include "session/tick_clock.hpp"

#include "document/events.hpp"

#include <algorithm>

namespace pastoso::session {
namespace {

/// A hand that has not moved for so long rests, or watches the paint run.
constexpr auto kRest = std::chrono::milliseconds(250);

/// Of the running means.
constexpr double kMeanTime_s = 0.5;

double seconds(WallClock::duration duration) {
    return std::chrono::duration<double>(duration).count();
}

WallClock::duration wall_time(double seconds) {
    return std::chrono::duration_cast<WallClock::duration>(std::chrono::duration<double>(seconds));
}

}  // namespace

TickClock::TickClock(WallClock::time_point now)
    : next_(now),
      previous_begin_(now - wall_time(document::kTick_s)),
      hand_moved_(now - kRest),
      mean_period_s_(document::kTick_s) {}

WallClock::time_point TickClock::next() const {
    return latest_cost_ > kFeltDelay ? std::max(next_, hand_moved_ + kRest) : next_;
}

double TickClock::wanted_period_s() const {
    return document::kTick_s / speed_;
}

void TickClock::set_speed(double speed) {
    if (speed == speed_) return;
    speed_ = speed;
    mean_period_s_ = wanted_period_s();
}

void TickClock::tick_ended(WallClock::time_point begin, WallClock::time_point end, bool passed) {
    latest_cost_ = end - begin;
    next_ = hurried_ ? end : std::max(next_ + wall_time(wanted_period_s()), end);
    if (!passed) return;
    const double period_s = std::max(seconds(begin - previous_begin_), seconds(end - begin));
    // A slow tick weighs by the time that it took, a quick one by that which it had.
    const double share = std::min(1.0, std::max(wanted_period_s(), period_s) / kMeanTime_s);
    mean_period_s_ += share * (period_s - mean_period_s_);
    mean_cost_s_ += share * (seconds(latest_cost_) - mean_cost_s_);
    previous_begin_ = begin;
}

void TickClock::restart(WallClock::time_point now) {
    const double speed = speed_;
    *this = TickClock(now);
    set_speed(speed);
}

double TickClock::load() const {
    return mean_cost_s_ / wanted_period_s();
}

double TickClock::paint_per_wall() const {
    return std::min(speed_, document::kTick_s / mean_period_s_);
}

}  // namespace pastoso::session
