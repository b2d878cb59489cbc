#include "session/frame_times.hpp"

#include <cmath>

#include <gmock/gmock.h>

namespace pastoso::session {
namespace {

using std::chrono::milliseconds;
using testing::DoubleNear;
using testing::ElementsAre;
using testing::IsEmpty;

FrameTimes::Clock::time_point at_ms(int ms) {
    return FrameTimes::Clock::time_point(milliseconds(ms));
}

/// Rounded.
std::vector<long> ms(const Durations& durations) {
    std::vector<long> rounded;
    for (const double s : durations.all_s)
        rounded.push_back(std::lround(1000.0 * s));
    return rounded;
}

TEST(Durations, PercentilesAreTheNearestRanks) {
    const Durations durations{{0.005, 0.001, 0.004, 0.002, 0.003}};
    EXPECT_EQ(durations.percentile_s(0.0), 0.001);
    EXPECT_EQ(durations.percentile_s(0.5), 0.003);
    EXPECT_EQ(durations.percentile_s(0.95), 0.005);
    EXPECT_EQ(durations.percentile_s(1.0), 0.005);
    EXPECT_EQ(Durations{}.percentile_s(0.5), 0.0);
}

TEST(FrameTimes, EachEventIsPublishedOnceInItsOrder) {
    FrameTimes times;
    const int first = 0, second = 0;
    times.posted(at_ms(0));
    times.posted(at_ms(2));
    times.published(1, &first, at_ms(5));
    times.posted(at_ms(6));
    times.published(2, &second, at_ms(9));
    times.published(3, &second, at_ms(20));
    EXPECT_THAT(times.event_to_snapshot().all_s,
                ElementsAre(DoubleNear(0.005, 1e-9), DoubleNear(0.007, 1e-9), DoubleNear(0.003, 1e-9)));
}

TEST(FrameTimes, ASnapshotThatIsPassedOverIsNeverOnTheScreen) {
    FrameTimes times;
    const int passed_over = 0, shown = 0, later = 0;
    times.published(0, &passed_over, at_ms(0));
    times.published(0, &shown, at_ms(10));
    times.published(0, &later, at_ms(20));
    times.presented(&shown, at_ms(26));
    times.presented(&passed_over, at_ms(27));
    times.presented(&shown, at_ms(28));
    EXPECT_THAT(times.snapshot_to_screen().all_s, ElementsAre(DoubleNear(0.016, 1e-9)));
    times.presented(&later, at_ms(30));
    EXPECT_EQ(times.snapshot_to_screen().all_s.size(), 2U);
}

TEST(FrameTimes, WhatWaitsInTheQueueIsWaitedFor) {
    FrameTimes times;
    // The device counts from elsewhere; its first event is heard at once.
    times.heard(7000.0, at_ms(100));
    times.posted(at_ms(101));
    times.heard(7010.0, at_ms(150));
    times.posted(at_ms(151));
    times.posted(at_ms(152));  // of no event
    int snapshot = 0;
    times.published(3, &snapshot, at_ms(160));
    EXPECT_THAT(ms(times.event_to_snapshot()), ElementsAre(60, 50, 8));
    times.presented(&snapshot, at_ms(170));
    EXPECT_THAT(ms(times.event_to_screen()), ElementsAre(70, 60, 18));
    EXPECT_THAT(ms(times.snapshot_to_screen()), ElementsAre(10));
}

TEST(FrameTimes, WhatWasPassedOverIsOnTheScreenWithWhatFollows) {
    FrameTimes times;
    times.posted(at_ms(10));
    times.posted(at_ms(20));
    int first = 0, second = 0;
    times.published(1, &first, at_ms(22));
    times.published(1, &second, at_ms(24));
    times.presented(&second, at_ms(30));
    EXPECT_THAT(ms(times.event_to_screen()), ElementsAre(20, 10));
}

TEST(FrameTimes, TheTableTellsCountsAndMilliseconds) {
    FrameTimes times;
    EXPECT_THAT(times.quiet_ticks().all_s, IsEmpty());
    times.quiet_tick(0.00125);
    EXPECT_THAT(times.table(), testing::HasSubstr("tick without paint          1      1.25"));
}

TEST(FrameTimes, AMarkComesWithTheFrameThatIsDrawnNext) {
    FrameTimes times;
    const int empty = 0, first = 0;
    times.published(0, &empty, at_ms(0));
    times.posted(at_ms(1));
    times.posted(at_ms(3));
    times.marked();
    times.posted(at_ms(4));
    times.presented(&empty, at_ms(6));
    EXPECT_THAT(ms(times.event_to_mark()), ElementsAre(5, 3));
    EXPECT_THAT(ms(times.event_to_screen()), IsEmpty());
    times.published(1, &first, at_ms(7));
    times.marked();
    times.presented(&first, at_ms(9));
    EXPECT_THAT(ms(times.event_to_mark()), ElementsAre(5, 3, 5));
    EXPECT_THAT(ms(times.event_to_screen()), ElementsAre(8));
}

TEST(FrameTimes, WhatIsThereWithoutAMarkIsSeenItself) {
    FrameTimes times;
    const int first = 0, second = 0;
    times.posted(at_ms(0));
    times.posted(at_ms(2));
    times.published(1, &first, at_ms(5));
    times.posted(at_ms(6));
    times.presented(&first, at_ms(8));
    EXPECT_THAT(ms(times.event_to_mark()), ElementsAre(8));
    times.published(2, &second, at_ms(9));
    times.presented(&second, at_ms(12));
    EXPECT_THAT(ms(times.event_to_mark()), ElementsAre(8, 10, 6));
    EXPECT_THAT(ms(times.event_to_screen()), ElementsAre(8, 10, 6));
}

}  // namespace
}  // namespace pastoso::session
