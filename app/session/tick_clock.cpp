#include "session/tick_clock.hpp"

#include "document/events.hpp"

#include <algorithm>

namespace pastoso::session {
namespace {

constexpr auto kTickPeriod =
    std::chrono::duration_cast<WallClock::duration>(std::chrono::duration<double>(document::kTick_s));

/// A hand that has not moved for so long rests, or watches the paint run.
constexpr auto kRest = std::chrono::milliseconds(250);

/// Weight of the newest period in the running mean: half a second of ticks.
constexpr double kNewestShare = 2.0 * document::kTick_s;

double seconds(WallClock::duration duration) {
    return std::chrono::duration<double>(duration).count();
}

}  // namespace

TickClock::TickClock(WallClock::time_point now)
    : next_(now),
      previous_begin_(now - kTickPeriod),
      hand_moved_(now - kRest),
      mean_period_s_(document::kTick_s) {}

WallClock::time_point TickClock::next() const {
    return latest_cost_ > kFeltDelay ? std::max(next_, hand_moved_ + kRest) : next_;
}

void TickClock::tick_ended(WallClock::time_point begin, WallClock::time_point end, bool passed) {
    latest_cost_ = end - begin;
    next_ = hurried_ ? end : std::max(next_ + kTickPeriod, end);
    if (!passed) return;
    const double period_s = std::max(seconds(begin - previous_begin_), seconds(end - begin));
    // A slow tick weighs by the time that it took, a quick one by its own length.
    const double share = std::min(1.0, kNewestShare * std::max(1.0, period_s / document::kTick_s));
    mean_period_s_ += share * (period_s - mean_period_s_);
    mean_cost_s_ += share * (seconds(latest_cost_) - mean_cost_s_);
    previous_begin_ = begin;
}

void TickClock::restart(WallClock::time_point now) {
    *this = TickClock(now);
}

double TickClock::load() const {
    return mean_cost_s_ / document::kTick_s;
}

double TickClock::paint_per_wall() const {
    return std::min(1.0, document::kTick_s / mean_period_s_);
}

}  // namespace pastoso::session
