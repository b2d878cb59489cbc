#include "tools/pace.hpp"

#include <utility>

#include <gtest/gtest.h>

namespace pastoso::tools {
namespace {

/// What is told once a share has lasted for long.
Pace told_after(double share) {
    PaceWatch watch(0.0);
    watch.look(share, 0.0);
    return watch.look(share, 10.0);
}

TEST(Pace, EveryShareHasItsName) {
    for (const auto& [share, pace] : {std::pair{20.0, Pace::Full},
                                      {1.0, Pace::Full},
                                      {0.5, Pace::Half},
                                      {0.333, Pace::Third},
                                      {0.25, Pace::Quarter},
                                      {0.2, Pace::Fifth},
                                      {0.1, Pace::Tenth},
                                      {0.05, Pace::Less},
                                      {0.0, Pace::Less}})
        EXPECT_EQ(told_after(share), pace) << share;
}

TEST(Pace, IsToldOnceItHasLastedForASecond) {
    PaceWatch watch(0.0);
    EXPECT_EQ(watch.look(1.0, 5.0), Pace::Full);
    EXPECT_EQ(watch.look(0.1, 5.5), Pace::Full);
    EXPECT_EQ(watch.look(0.1, 5.9), Pace::Full);
    EXPECT_EQ(watch.look(0.1, 6.0), Pace::Tenth);
    EXPECT_EQ(watch.look(1.0, 6.5), Pace::Tenth);
    EXPECT_EQ(watch.look(1.0, 7.0), Pace::Full);
}

TEST(Pace, WhatPassesWithinASecondIsNotTold) {
    PaceWatch watch(0.0);
    for (int half_s = 0; half_s < 20; ++half_s)
        EXPECT_EQ(watch.look(half_s % 2 == 0 ? 0.3 : 1.0, 0.5 * half_s), Pace::Full);
}

TEST(Pace, AShareThatWaversAtTheBorderChangesNothing) {
    PaceWatch watch(0.0);
    watch.look(0.5, 0.0);
    ASSERT_EQ(watch.look(0.5, 2.0), Pace::Half);
    for (const double border : {0.77, 0.408}) {
        EXPECT_EQ(watch.look(1.05 * border, 10.0), Pace::Half) << border;
        EXPECT_EQ(watch.look(1.05 * border, 20.0), Pace::Half) << border;
        EXPECT_EQ(watch.look(0.95 * border, 30.0), Pace::Half) << border;
        EXPECT_EQ(watch.look(0.95 * border, 40.0), Pace::Half) << border;
    }
    watch.look(0.86, 50.0);
    EXPECT_EQ(watch.look(0.86, 60.0), Pace::Full);
    EXPECT_EQ(watch.look(0.72, 70.0), Pace::Full) << "it comes later than it goes";
    EXPECT_EQ(watch.look(0.72, 80.0), Pace::Full);
}

}  // namespace
}  // namespace pastoso::tools
