#include "brush/pen_filter.hpp"

#include "core/units.hpp"

#include <algorithm>
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

/// The tip after the pen has run around a quarter of a circle of 20 mm in a second.
PenSample pulled_around(double string_mm, double rate_Hz) {
    PenFilter filter(0.0, string_mm);
    filter.start({.x_mm = 20.0});
    const int count = static_cast<int>(rate_Hz);
    PenSample out;
    for (int i = 1; i <= count; ++i) {
        const double angle = 0.5 * core::kPi * i / count;
        out = filter.follow(
            {.time_s = i / rate_Hz, .x_mm = 20.0 * std::cos(angle), .y_mm = 20.0 * std::sin(angle)});
    }
    return out;
}

TEST(PenFilter, TheStringTrailsLikeATractrix) {
    PenFilter filter(0.0, 2.0);
    filter.start({});
    filter.follow({.time_s = 0.1, .x_mm = 2.0});
    // Pulled at right angles; the tractrix's own equation for the way of the pulling hand.
    const PenSample out = filter.follow({.time_s = 0.2, .x_mm = 2.0, .y_mm = 3.0});
    const double away_mm = 2.0 - out.x_mm;
    const double behind_mm = std::sqrt(4.0 - away_mm * away_mm);
    EXPECT_NEAR(out.y_mm, 3.0 - behind_mm, 1e-12);
    EXPECT_NEAR(3.0, 2.0 * std::atanh(behind_mm / 2.0), 1e-12);
}

TEST(PenFilter, TheStringDoesNotDependOnTheEventRate) {
    const PenSample fast = pulled_around(5.0, 1000.0), slow = pulled_around(5.0, 60.0);
    // What the chords of 0.5 mm miss of the circle: 0.5^2 / (8 * 20) mm.
    EXPECT_NEAR(fast.x_mm, slow.x_mm, 0.0016);
    EXPECT_NEAR(fast.y_mm, slow.y_mm, 0.0016);
}

TEST(PenFilter, TheStringCutsNoPullInTwo) {
    PenFilter whole(0.0, 3.0), parts(0.0, 3.0);
    whole.start({});
    parts.start({});
    for (int i = 1; i <= 7; ++i)
        parts.follow({.time_s = 0.1 * i, .x_mm = 1.0 * i, .y_mm = 0.5 * i});
    whole.follow({.time_s = 0.7, .x_mm = 7.0, .y_mm = 3.5});
    for (int i = 1; i <= 9; ++i)
        parts.follow({.time_s = 1.0 + i, .x_mm = 7.0 - i, .y_mm = 3.5 + 2.0 * i});
    const PenSample once = whole.follow({.time_s = 10.0, .x_mm = -2.0, .y_mm = 21.5});
    const PenSample often = parts.follow({.time_s = 10.0, .x_mm = -2.0, .y_mm = 21.5});
    EXPECT_NEAR(once.x_mm, often.x_mm, 1e-12);
    EXPECT_NEAR(once.y_mm, often.y_mm, 1e-12);
}

StrokePreset preset_stroke() {
    StrokePreset stroke;
    stroke.smoothing_ms = 10.0;
    stroke.string_mm = 1.0;
    return stroke;
}

/// How many seconds the filter is late behind a hand at 100 mm/s.
double lag_s(PenFilter filter, double rate_Hz) {
    filter.start({});
    double x_mm = 0.0;
    const int count = static_cast<int>(3.0 * rate_Hz);
    for (int i = 1; i <= count; ++i)
        x_mm = filter.follow({.time_s = i / rate_Hz, .x_mm = 100.0 * i / rate_Hz}).x_mm;
    return 3.0 - x_mm / 100.0;
}

TEST(Stabiliser, AddsItsSmoothingToTheBrushs) {
    StrokePreset stroke = preset_stroke();
    stroke.string_mm = 0.0;
    for (const double rate_Hz : {125.0, 1000.0}) {
        EXPECT_NEAR(lag_s(steadying_filter(stroke, {}), rate_Hz), 0.010, 1e-9);
        EXPECT_NEAR(lag_s(steadying_filter(stroke, {200.0, 0.0}), rate_Hz), 0.210, 1e-6);  // e^(-3/0.21)
    }
}

TEST(Stabiliser, TheLongerStringPulls) {
    StrokePreset stroke = preset_stroke();
    stroke.smoothing_ms = 0.0;
    EXPECT_NEAR(lag_s(steadying_filter(stroke, {}), 125.0), 0.01, 1e-9);
    EXPECT_NEAR(lag_s(steadying_filter(stroke, {0.0, 4.0}), 125.0), 0.04, 1e-9);
    EXPECT_NEAR(lag_s(steadying_filter(stroke, {0.0, 0.5}), 125.0), 0.01, 1e-9);
}

TEST(Stabiliser, SteadiesATremor) {
    const auto residual_mm = [](const Stabiliser& stabiliser) {
        PenFilter filter = steadying_filter(preset_stroke(), stabiliser);
        filter.start({});
        double largest = 0.0;
        for (int i = 1; i <= 2000; ++i) {
            const double time_s = 0.001 * i;  // 9 Hz, 1 mm, as hands tremble
            const double y_mm = std::sin(2.0 * core::kPi * 9.0 * time_s);
            const PenSample out = filter.follow({.time_s = time_s, .x_mm = 50.0 * time_s, .y_mm = y_mm});
            if (i > 1000) largest = std::max(largest, std::abs(out.y_mm));
        }
        return largest;
    };
    // One pole of 110 ms: 1 / sqrt(1 + (2 pi 9 0.11)^2) = 0.16, less what the string takes.
    EXPECT_LT(residual_mm({100.0, 0.0}), 0.17);
    EXPECT_LT(residual_mm({0.0, 5.0}), 0.25);
    EXPECT_GT(residual_mm({}), 0.4);
}

TEST(Stabiliser, EndsWhereThePenEnded) {
    PenFilter filter = steadying_filter(preset_stroke(), {500.0, 8.0});
    filter.start({});
    filter.follow({.time_s = 0.1, .x_mm = 40.0, .y_mm = 3.0, .pressure = 0.2});
    const PenSample last = filter.final_sample();
    EXPECT_EQ(last.x_mm, 40.0);
    EXPECT_EQ(last.y_mm, 3.0);
    EXPECT_EQ(last.pressure, 0.2);
}

TEST(Stabiliser, CatchesUpWithAPenThatRests) {
    PenFilter filter = steadying_filter({}, {200.0, 0.0});
    filter.start({});
    for (int i = 1; i <= 20; ++i)
        filter.follow({.time_s = 0.01 * i, .x_mm = 1.0 * i});
    EXPECT_LT(filter.follow({.time_s = 0.2, .x_mm = 20.0}).x_mm, 10.0);
    const PenSample rested = filter.follow({.time_s = 180.0, .x_mm = 20.0});
    EXPECT_NEAR(rested.x_mm, 20.0, 1e-9);
}

}  // namespace
}  // namespace pastoso::brush
