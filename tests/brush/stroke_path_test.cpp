#include "brush/stroke_path.hpp"

#include <cmath>

#include <gtest/gtest.h>

namespace pastoso::brush {
namespace {

constexpr double kStep_mm = 0.5;

std::vector<PathStep> walk(const PathMeasure& measure, const std::vector<PenSample>& samples) {
    StrokePath path(measure);
    path.begin(samples.front(), 0.0, 1.0);
    for (std::size_t i = 1; i < samples.size(); ++i)
        path.add(samples[i]);
    path.end();
    return path.take_steps();
}

std::vector<PenSample> sampled(int count, double duration_s, PenSample (*at)(double)) {
    std::vector<PenSample> samples;
    for (int i = 0; i <= count; ++i) {
        const double time_s = duration_s * i / count;
        samples.push_back(at(time_s));
        samples.back().time_s = time_s;
    }
    return samples;
}

PenSample straight(double time_s) {
    return {.x_mm = 100.0 * time_s, .y_mm = 7.0, .pressure = 0.5};
}

PenSample circling(double time_s) {
    return {
        .x_mm = 20.0 * std::cos(6.0 * time_s), .y_mm = 20.0 * std::sin(6.0 * time_s), .pressure = 0.5};
}

TEST(StrokePath, StepsAreEquallyLong) {
    const auto steps = walk({kStep_mm, 0.0, 0.0}, sampled(37, 1.0, straight));
    ASSERT_EQ(steps.size(), 200U);
    for (std::size_t i = 0; i < steps.size(); ++i) {
        EXPECT_NEAR(steps[i].pen.x_mm, kStep_mm * (static_cast<double>(i) + 1.0), 1e-9);
        EXPECT_NEAR(steps[i].pen.y_mm, 7.0, 1e-12);
        EXPECT_NEAR(steps[i].direction_x, 1.0, 1e-12);
        EXPECT_NEAR(steps[i].speed_mm_s, 100.0, 1e-6);
    }
}

TEST(StrokePath, DoesNotDependOnTheEventRate) {
    const auto dense = walk({kStep_mm, 0.0, 0.0}, sampled(1000, 1.0, circling));
    const auto sparse = walk({kStep_mm, 0.0, 0.0}, sampled(125, 1.0, circling));
    ASSERT_EQ(dense.size(), sparse.size());
    // The cubic's error at 0.96 mm between samples on a radius of 20 mm is below 1e-4 mm; lengths add
    // up.
    for (std::size_t i = 0; i < dense.size(); ++i) {
        EXPECT_NEAR(dense[i].pen.x_mm, sparse[i].pen.x_mm, 0.01);
        EXPECT_NEAR(dense[i].pen.y_mm, sparse[i].pen.y_mm, 0.01);
    }
}

TEST(StrokePath, PausesDoNothing) {
    std::vector<PenSample> samples = sampled(10, 0.1, straight);
    const auto moving = walk({kStep_mm, 1.0, 1.0}, samples);
    PenSample rest = samples.back();
    for (int i = 0; i < 50; ++i) {
        rest.time_s += 0.1;
        samples.push_back(rest);
    }
    const auto paused = walk({kStep_mm, 1.0, 1.0}, samples);
    EXPECT_EQ(paused.size(), moving.size());
}

TEST(StrokePath, DoesNotSwingBackAfterAPause) {
    std::vector<PenSample> samples = {
        {.time_s = 0.0}, {.time_s = 0.01, .x_mm = 1.0}, {.time_s = 5.0, .x_mm = 1.1}};
    for (int i = 1; i <= 10; ++i) {
        samples.push_back({.time_s = 5.0 + 0.008 * i, .x_mm = 1.1 + 2.0 * i});
    }
    double farthest = 0.0;
    for (const PathStep& step : walk({0.05, 0.0, 0.0}, samples)) {
        EXPECT_GT(step.pen.x_mm, farthest - 0.03);  // a tenth of the shortest chord
        farthest = std::max(farthest, step.pen.x_mm);
    }
}

TEST(StrokePath, PressingDownCountsAsWay) {
    StrokePath path({kStep_mm, 4.0, 0.0});
    path.begin({.x_mm = 3.0, .pressure = 0.5}, 0.6, 0.8);
    const auto steps = path.take_steps();
    ASSERT_EQ(steps.size(), 4U);
    for (std::size_t i = 0; i < 4; ++i) {
        EXPECT_NEAR(steps[i].pen.pressure, 0.125 * (static_cast<double>(i) + 1.0), 1e-12);
        EXPECT_EQ(steps[i].pen.x_mm, 3.0);
        EXPECT_EQ(steps[i].direction_x, 0.6);
    }
}

TEST(StrokePath, TurningInPlaceCountsAsWay) {
    const auto steps =
        walk({kStep_mm, 0.0, 10.0}, {{.time_s = 0.0, .pressure = 0.5},
                                     {.time_s = 0.1, .pressure = 0.5, .rotation_deg = 30.0},
                                     {.time_s = 0.2, .pressure = 0.5, .rotation_deg = 60.0}});
    EXPECT_EQ(steps.size(), 20U);  // 10 mm * pi / 3 = 10.47 mm
}

TEST(StrokePath, EndsAtTheLastSample) {
    for (int count = 1; count <= 5; ++count) {
        const auto steps = walk({0.01, 0.0, 0.0}, sampled(count, 0.05, straight));
        ASSERT_FALSE(steps.empty());
        EXPECT_NEAR(steps.back().pen.x_mm, 5.0, 0.0101);  // within a step
    }
}

TEST(StrokePath, PressureStaysWithinRange) {
    std::vector<PenSample> samples;
    for (int i = 0; i < 20; ++i) {
        samples.push_back({.time_s = 0.01 * i, .x_mm = 1.0 * i, .pressure = i % 2 == 0 ? 0.0 : 1.0});
    }
    for (const PathStep& step : walk({0.1, 0.0, 0.0}, samples)) {
        EXPECT_GE(step.pen.pressure, 0.0);
        EXPECT_LE(step.pen.pressure, 1.0);
    }
}

}  // namespace
}  // namespace pastoso::brush
