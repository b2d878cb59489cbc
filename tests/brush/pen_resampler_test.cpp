#include "brush/pen_resampler.hpp"

#include "brush/pen_filter.hpp"

#include <cmath>
#include <vector>

#include <gtest/gtest.h>

namespace pastoso::brush {
namespace {

/// A hand that turns and presses.
PenSample curved(double time_s) {
    return {.time_s = time_s,
            .x_mm = 70.0 * time_s,
            .y_mm = 8.0 * std::sin(6.0 * time_s),
            .pressure = 0.1 + (0.2 + 0.6 * time_s) * time_s,
            .rotation_deg = 170.0 + 40.0 * time_s};
}

std::vector<PenSample> filled(double rate_Hz, int count) {
    PenResampler events;
    events.start(curved(0.0));
    std::vector<PenSample> all;
    const auto append = [&](const std::vector<PenSample>& some) {
        all.insert(all.end(), some.begin(), some.end());
    };
    for (int i = 1; i <= count; ++i)
        append(events.add(curved(i / rate_Hz)));
    append(events.end());
    return all;
}

TEST(PenResampler, LeavesFastEventsAsTheyAre) {
    const std::vector<PenSample> samples = filled(500.0, 50);
    ASSERT_EQ(samples.size(), 50U);
    for (int i = 0; i < 50; ++i)
        EXPECT_EQ(samples[i].x_mm, curved((i + 1) / 500.0).x_mm);
}

TEST(PenResampler, FillsUpSlowOnesAlongTheCurve) {
    const std::vector<PenSample> samples = filled(125.0, 50);
    ASSERT_EQ(samples.size(), 200U);
    // Inner pieces have a parabola exactly and miss a curve by some h^3 f''' / 70 through their
    // tangents; those at the ends, whose outer tangent is the chord's, by h^2 f'' 2 / 27.
    for (std::size_t i = 0; i < samples.size(); ++i) {
        const PenSample expected = curved(0.002 * (static_cast<double>(i) + 1.0));
        const bool at_end = i < 4 || i >= 196;
        EXPECT_NEAR(samples[i].time_s, expected.time_s, 1e-12);
        EXPECT_NEAR(samples[i].pressure, expected.pressure, at_end ? 6e-6 : 1e-12) << i;
        EXPECT_NEAR(samples[i].y_mm, expected.y_mm, at_end ? 1.4e-3 : 4e-5) << i;
    }
}

TEST(PenResampler, MakesTheFilterIndependentOfTheEventRate) {
    const auto filtered = [](double rate_Hz) {
        PenFilter filter(0.010, 0.0);
        filter.start(curved(0.0));
        PenSample out;
        for (const PenSample& sample : filled(rate_Hz, static_cast<int>(rate_Hz))) {
            if (sample.time_s < 0.8001) out = filter.follow(sample);
        }
        return out;
    };
    const PenSample fast = filtered(1000.0), slow = filtered(125.0);
    EXPECT_NEAR(slow.time_s, fast.time_s, 1e-12);
    // The filter takes the hand for straight, h^2 f'' / 12 behind it; h is 2 ms here, not 8.
    EXPECT_NEAR(slow.y_mm, fast.y_mm, 1e-4);
    EXPECT_NEAR(slow.pressure, fast.pressure, 5e-7);
}

TEST(PenResampler, TellsARestInFewSamples) {
    PenResampler events;
    events.start({});
    events.add({.time_s = 0.01, .x_mm = 1.0});
    events.add({.time_s = 60.0, .x_mm = 1.0});
    EXPECT_LE(events.end().size(), 32U);
    for (const PenSample& sample : events.end())
        EXPECT_NEAR(sample.x_mm, 1.0, 1e-12);
}

TEST(PenResampler, SurvivesRepeatedAndBackwardTimes) {
    PenResampler events;
    events.start({.time_s = 5.0});
    double time_s = 5.0;
    for (const double given_s : {5.0, 5.0, 4.0, 5.0, 5.01}) {
        for (const PenSample& sample : events.add({.time_s = given_s, .x_mm = 1.0})) {
            EXPECT_GT(sample.time_s, time_s);
            EXPECT_TRUE(std::isfinite(sample.x_mm));
            time_s = sample.time_s;
        }
    }
}

TEST(PenResampler, TurnsTheShortWayRound) {
    PenResampler events;
    events.start({.rotation_deg = 350.0});
    events.add({.time_s = 0.1, .rotation_deg = 10.0});
    EXPECT_DOUBLE_EQ(events.end().back().rotation_deg, 370.0);
}

TEST(PenResampler, GivesATapNoSamples) {
    PenResampler events;
    events.start({});
    EXPECT_TRUE(events.end().empty());
}

}  // namespace
}  // namespace pastoso::brush
