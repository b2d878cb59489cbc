#include "session/tick_clock.hpp"

#include "document/events.hpp"

#include <gtest/gtest.h>

namespace pastoso::session {
namespace {

using Seconds = std::chrono::duration<double>;

WallClock::time_point at(double seconds) {
    return WallClock::time_point() + std::chrono::duration_cast<WallClock::duration>(Seconds(seconds));
}

/// Runs ticks that each take `cost_s` until `end_s`, and counts them.
int ticks_until(TickClock& clock, double end_s, double cost_s) {
    int ticks = 0;
    double now_s = 0.0;
    while (now_s < end_s) {
        if (!clock.due(at(now_s))) {
            now_s += 1e-4;
            continue;
        }
        clock.tick_ended(at(now_s), at(now_s + cost_s), true);
        now_s += cost_s;
        ++ticks;
    }
    return ticks;
}

TEST(TickClock, QuickTicksKeepTimeWithTheWall) {
    TickClock clock(at(0.0));
    // One tick is due at the very start, and one may straddle the end.
    EXPECT_NEAR(ticks_until(clock, 2.0, 0.001), 2.0 / document::kTick_s, 1.0);
    EXPECT_NEAR(clock.paint_per_wall(), 1.0, 0.01);  // the loop above looks every 0.1 ms
    EXPECT_NEAR(clock.load(), 0.001 / document::kTick_s, 1e-3);
}

TEST(TickClock, HurriedTicksFollowOneAnother) {
    TickClock clock(at(0.0));
    clock.set_hurried(true);
    EXPECT_NEAR(ticks_until(clock, 2.0, 0.004), 500, 1);
    clock.set_hurried(false);
    clock.tick_ended(at(2.0), at(2.004), true);
    EXPECT_FALSE(clock.due(at(2.010)));
    EXPECT_TRUE(clock.due(at(2.017)));
}

TEST(TickClock, SlowTicksMakePaintTimeSlow) {
    TickClock clock(at(0.0));
    EXPECT_NEAR(ticks_until(clock, 2.0, 4.0 * document::kTick_s), 0.25 * 2.0 / document::kTick_s, 1.0);
    EXPECT_NEAR(clock.paint_per_wall(), 0.25, 0.01);
    EXPECT_NEAR(clock.load(), 4.0, 0.08);  // a fiftieth of the idle time before is still in the mean
}

TEST(TickClock, FasterTicksComeSooner) {
    TickClock clock(at(0.0));
    clock.set_speed(10.0);
    EXPECT_NEAR(ticks_until(clock, 2.0, 0.0005), 20.0 / document::kTick_s, 1.0);
    EXPECT_NEAR(clock.paint_per_wall(), 10.0, 0.1);  // the loop above looks every 0.1 ms
    // A fiftieth of the idle time before is still in the mean.
    EXPECT_NEAR(clock.load(), 0.0005 * 10.0 / document::kTick_s, 0.02 * 0.3);
}

TEST(TickClock, FasterTimeIsAsFastAsItsTicks) {
    TickClock clock(at(0.0));
    clock.set_speed(10.0);
    EXPECT_NEAR(ticks_until(clock, 2.0, 0.25 * document::kTick_s), 8.0 / document::kTick_s, 1.0);
    EXPECT_NEAR(clock.paint_per_wall(), 4.0, 0.1);
}

TEST(TickClock, AnotherSpeedIsMeasuredAnew) {
    TickClock clock(at(0.0));
    ticks_until(clock, 2.0, 4.0 * document::kTick_s);
    clock.set_speed(10.0);
    EXPECT_DOUBLE_EQ(clock.paint_per_wall(), 10.0);
    clock.restart(at(100.0));
    EXPECT_DOUBLE_EQ(clock.speed(), 10.0) << "a pause does not change it";
    EXPECT_DOUBLE_EQ(clock.paint_per_wall(), 10.0);
}

TEST(TickClock, ADebtOfTicksIsDropped) {
    TickClock clock(at(0.0));
    clock.tick_ended(at(0.0), at(1.0), true);
    EXPECT_TRUE(clock.due(at(1.0)));
    clock.tick_ended(at(1.0), at(1.0), true);
    EXPECT_FALSE(clock.due(at(1.0 + 0.9 * document::kTick_s)));
    EXPECT_TRUE(clock.due(at(1.0 + 1.1 * document::kTick_s)));
}

TEST(TickClock, SlowTicksWaitForTheHandToRest) {
    TickClock clock(at(0.0));
    clock.tick_ended(at(0.0), at(0.1), true);
    clock.hand_moved(at(0.09));
    EXPECT_FALSE(clock.due(at(0.1)));
    EXPECT_FALSE(clock.due(at(0.3)));
    EXPECT_TRUE(clock.due(at(0.35)));
    clock.hand_moved(at(0.34));
    EXPECT_FALSE(clock.due(at(0.35)));
}

TEST(TickClock, QuickTicksDoNotWaitForTheHand) {
    TickClock clock(at(0.0));
    clock.tick_ended(at(0.0), at(0.005), true);
    clock.hand_moved(at(0.016));
    EXPECT_TRUE(clock.due(at(0.017)));
}

TEST(TickClock, RestartForgetsThePause) {
    TickClock clock(at(0.0));
    clock.tick_ended(at(0.0), at(0.0), true);
    clock.restart(at(100.0));
    EXPECT_TRUE(clock.due(at(100.0)));
    EXPECT_DOUBLE_EQ(clock.paint_per_wall(), 1.0);
}

// A tick that was given up passes no time, but its cost is remembered: the next waits for the hand.
TEST(TickClock, AnAbandonedTickWaitsForTheHandToRest) {
    TickClock clock(at(0.0));
    clock.hand_moved(at(0.03));
    clock.tick_ended(at(0.0), at(0.04), false);
    EXPECT_DOUBLE_EQ(clock.paint_per_wall(), 1.0);
    EXPECT_FALSE(clock.due(at(0.1)));
    EXPECT_TRUE(clock.due(at(0.29)));
}

}  // namespace
}  // namespace pastoso::session
