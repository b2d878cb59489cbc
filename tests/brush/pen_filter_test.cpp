#include "brush/pen_filter.hpp"

#include <cmath>

#include <gtest/gtest.h>

namespace pastoso::brush {
namespace {

constexpr double kTimeConstant_s = 0.010;

class PenFilterRate : public testing::TestWithParam<double> {};

TEST_P(PenFilterRate, FollowsASteadyHandOneTimeConstantLate) {
    PenFilter filter(kTimeConstant_s, 0.0);
    filter.start({});
    PenSample out;
    const double step_s = 1.0 / GetParam();
    double time_s = 0.0;
    for (; time_s < 0.5; time_s += step_s)
        out = filter.follow({.time_s = time_s, .x_mm = 100.0 * time_s});
    const double lag_s = (time_s - step_s) - out.x_mm / 100.0;
    EXPECT_NEAR(lag_s, kTimeConstant_s, 1e-9);  // exact for straight input, at any rate
}

INSTANTIATE_TEST_SUITE_P(Rates, PenFilterRate, testing::Values(60.0, 125.0, 1000.0));

TEST(PenFilter, AnswersAStepAsOnePoleDoes) {
    PenFilter filter(kTimeConstant_s, 0.0);
    filter.start({});
    filter.follow({.time_s = 1.0, .x_mm = 0.0});
    filter.follow({.time_s = 1.0001, .x_mm = 1.0});
    const PenSample out = filter.follow({.time_s = 1.0201, .x_mm = 1.0});
    EXPECT_NEAR(out.x_mm, 1.0 - std::exp(-2.0), 1e-3);  // the step itself takes 0.1 ms
}

TEST(PenFilter, FinalSampleIsTheLastOne) {
    PenFilter filter(kTimeConstant_s, 0.0);
    filter.start({});
    filter.follow({.time_s = 0.1, .x_mm = 10.0, .y_mm = 3.0, .pressure = 0.2});
    const PenSample last = filter.final_sample();
    EXPECT_EQ(last.x_mm, 10.0);
    EXPECT_EQ(last.y_mm, 3.0);
    EXPECT_EQ(last.pressure, 0.2);
    EXPECT_GT(last.time_s, 0.1);
}

TEST(PenFilter, SurvivesRepeatedAndBackwardTimes) {
    PenFilter filter(kTimeConstant_s, 0.0);
    double time_s = filter.start({.time_s = 5.0}).time_s;
    for (const double given_s : {5.0, 5.0, 4.0, 5.0, 5.01}) {
        const PenSample out = filter.follow({.time_s = given_s, .x_mm = 1.0});
        EXPECT_GT(out.time_s, time_s);
        EXPECT_TRUE(std::isfinite(out.x_mm));
        time_s = out.time_s;
    }
}

TEST(PenFilter, WithoutTimeConstantPassesSamplesOn) {
    PenFilter filter(0.0, 0.0);
    filter.start({});
    EXPECT_EQ(filter.follow({.time_s = 0.1, .x_mm = 4.0}).x_mm, 4.0);
}

TEST(PenFilter, TurnsTheShortWayRound) {
    PenFilter filter(0.0, 0.0);
    filter.start({.rotation_deg = 350.0});
    EXPECT_DOUBLE_EQ(filter.follow({.time_s = 0.1, .rotation_deg = 10.0}).rotation_deg, 370.0);
    EXPECT_DOUBLE_EQ(filter.follow({.time_s = 0.2, .rotation_deg = 340.0}).rotation_deg, 340.0);
}

TEST(PenFilter, PullsOnItsString) {
    PenFilter filter(0.0, 2.0);
    filter.start({});
    EXPECT_EQ(filter.follow({.time_s = 0.1, .x_mm = 1.5}).x_mm, 0.0);
    EXPECT_DOUBLE_EQ(filter.follow({.time_s = 0.2, .x_mm = 5.0}).x_mm, 3.0);
    EXPECT_EQ(filter.final_sample().x_mm, 5.0);
}

}  // namespace
}  // namespace pastoso::brush
