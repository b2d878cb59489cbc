// When the next tick of paint time is due, and how fast paint time passes against the clock on the wall.
#pragma once

#include <chrono>

namespace pastoso::session {

using WallClock = std::chrono::steady_clock;

/// A brush that lags by more than this feels detached from the hand.
inline constexpr auto kFeltDelay = std::chrono::milliseconds(30);

/// Paces ticks of document::kTick_s. Paint that is too slow to compute runs late and stays late: a debt
/// of ticks is dropped, never caught up, so that a heavy moment costs slow paint and not a frozen brush.
/// While ticks take so long that the hand would feel them, they wait until the hand has rested for a
/// moment.
class TickClock {
  public:
    explicit TickClock(WallClock::time_point now);

    bool due(WallClock::time_point now) const { return now >= next(); }
    WallClock::time_point next() const;

    /// How much faster than the clock on the wall paint time passes where the ticks are quick enough: 1,
    /// or more. What paint_per_wall() tells starts anew where it changes.
    void set_speed(double speed);
    double speed() const { return speed_; }

    /// Hurried, a tick is due as soon as the one before has been computed.
    void set_hurried(bool hurried) { hurried_ = hurried; }

    /// The brush was moved, on the canvas or above it.
    void hand_moved(WallClock::time_point when) { hand_moved_ = when; }

    /// Tells that the tick that was due has been computed between these two moments, or was given up.
    void tick_ended(WallClock::time_point begin, WallClock::time_point end, bool passed);

    /// Starts anew at `now`, for example after a pause, at the same speed.
    void restart(WallClock::time_point now);

    /// Paint time over wall time in about the last half second, 0 to speed().
    double paint_per_wall() const;

    /// What a tick takes to compute, over the time it has to pass in, in about the last half second: 1
    /// and more where paint time falls behind.
    double load() const;

  private:
    double wanted_period_s() const;

    WallClock::time_point next_;
    WallClock::time_point previous_begin_;
    WallClock::time_point hand_moved_;
    WallClock::duration latest_cost_{};
    bool hurried_ = false;
    double speed_ = 1.0;
    double mean_period_s_;
    double mean_cost_s_ = 0.0;
};

}  // namespace pastoso::session
