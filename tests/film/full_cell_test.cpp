// Cells that are full: whatever drives paint on, no cell comes to hold more than kMaxThickness_mm or
// more of a channel than its integer counts, and nothing is lost.
#include "film/film_bench.hpp"
#include "film/schemes.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <utility>

#include <gtest/gtest.h>

namespace pastoso::film::test {
namespace {

constexpr std::int32_t kFullChannel = std::numeric_limits<std::int32_t>::max();

std::int32_t thickest(const Bench& bench) {
    std::int32_t result = 0;
    for (int y = 0; y < bench.setup.height; ++y)
        for (int x = 0; x < bench.setup.width; ++x) {
            result = std::max(result, bench.state.thickness.at(x, y));
            EXPECT_GE(bench.state.thickness.at(x, y), 0) << x << ' ' << y;
        }
    return result;
}

/// The smallest and the largest amount in a channel of any cell.
std::pair<std::int32_t, std::int32_t> channel_range(const Bench& bench, int channel) {
    std::pair<std::int32_t, std::int32_t> range{kFullChannel, 0};
    for (int y = 0; y < bench.setup.height; ++y)
        for (int x = 0; x < bench.setup.width; ++x) {
            const std::int32_t amount = bench.state.paint.at(x, y)[channel];
            range = {std::min(range.first, amount), std::max(range.second, amount)};
        }
    return range;
}

/// A flat tank that a strong force tilts.
Scene tank(const Scheme& scheme, int width, int height) {
    return {.width = width,
            .height = height,
            .gravity = 1,
            .force_x = 8,
            .force_y = 5,
            .viscosity = 30,
            .edge_x = Edge::Wall,
            .edge_y = Edge::Wall,
            .solver = scheme.options};
}

/// A step in which paint as thick as may be falls by a fifth of a cell, the most of a large step.
constexpr double kStep_s = 0.01;

class FullCell : public testing::TestWithParam<Scheme> {};

TEST_P(FullCell, TakesNoMoreThanItMayHold) {
    Scene scene = tank(GetParam(), 2, 1);
    scene.force_x = 15;
    Bench bench(scene);
    bench.fill([](int x, int) { return x == 0 ? 9.0 : 10.0; });
    bench.tint(3, [](int, int) { return 1043.0; });
    const Totals before = totals(bench.state);
    AdvanceReport report;
    for (int step = 0; step < 1600; ++step) {
        report.add(bench.solver->step(kStep_s));
        ASSERT_LE(bench.state.thickness.at(1, 0), kMaxThickness_quanta);
        ASSERT_GE(bench.state.thickness.at(0, 0), 0);
    }
    EXPECT_GT(bench.h(1, 0), 0.99 * kMaxThickness_mm);
    EXPECT_GT(report.clamped_faces, 0);
    EXPECT_EQ(totals(bench.state).thickness, before.thickness);
    EXPECT_EQ(totals(bench.state).paint, before.paint);
}

TEST_P(FullCell, OfATiltedTankStandAtTheCap) {
    for (const int width : {1, 5, 70}) {
        Bench bench(tank(GetParam(), width, 9));
        bench.fill([](int x, int y) { return 6.0 + 0.5 * ((x + y) % 3); });
        bench.tint(7, [](int x, int) { return 1043.0 - 10.0 * (x % 2); });
        const Totals before = totals(bench.state);
        for (int step = 0; step < 400; ++step) {
            bench.solver->step(kStep_s);
            ASSERT_LE(thickest(bench), kMaxThickness_quanta) << width << " wide, step " << step;
        }
        EXPECT_GT(bench.max_h(), 0.95 * kMaxThickness_mm) << width;
        EXPECT_GE(channel_range(bench, 7).first, 0) << width;
        EXPECT_EQ(totals(bench.state).thickness, before.thickness) << width;
        EXPECT_EQ(totals(bench.state).paint, before.paint) << width;
    }
}

// Paint that dried on in a thin film may be stronger than any of the palette.
TEST_P(FullCell, KeepsOutPigmentThatItCannotCount) {
    for (const int width : {3, 66}) {
        Bench bench(tank(GetParam(), width, 4));
        bench.fill([](int, int) { return 5.0; });
        bench.tint(3, [](int, int) { return 3000.0; });
        const Totals before = totals(bench.state);
        AdvanceReport report;
        for (int step = 0; step < 400; ++step) {
            report.add(bench.solver->step(kStep_s));
            ASSERT_GE(channel_range(bench, 3).first, 0) << width << " wide, step " << step;
        }
        EXPECT_GT(channel_range(bench, 3).second, 0.9 * kFullChannel) << width;
        EXPECT_GT(report.clamped_faces, 0);
        EXPECT_EQ(totals(bench.state).paint, before.paint) << width;
    }
}

// Something else may have filled cells further: what is there may leave, and nothing comes in.
TEST_P(FullCell, OnlyEmptiesAboveTheCap) {
    Scene scene = tank(GetParam(), 6, 6);
    Bench bench(scene);
    bench.fill([](int x, int y) { return x + y > 5 ? 40.0 : 2.0; });
    const std::int32_t start = thickest(bench);
    const Totals before = totals(bench.state);
    for (int step = 0; step < 100; ++step) {
        bench.solver->step(kStep_s);
        ASSERT_LE(thickest(bench), start);
    }
    EXPECT_EQ(totals(bench.state).thickness, before.thickness);
}

/// Paint near the cap on a canvas of a few cells, driven by any force, with any edges.
Scene wild_scene(const Scheme& scheme, std::mt19937& random) {
    const auto between = [&](double low, double high) {
        return std::uniform_real_distribution<double>(low, high)(random);
    };
    const auto edge = [&] {
        return static_cast<Edge>(std::uniform_int_distribution<int>(0, 2)(random));
    };
    return {.width = std::uniform_int_distribution<int>(1, 9)(random),
            .height = std::uniform_int_distribution<int>(1, 9)(random),
            .gravity = between(0, 20),
            .force_x = between(-300, 300),
            .force_y = between(-300, 300),
            .viscosity = std::pow(10, between(-2, 2)),
            .tension = between(0, 50),
            .yield = between(-3, 3),
            .tan_advancing = between(-0.5, 1),
            .edge_x = edge(),
            .edge_y = edge(),
            .solver = scheme.options};
}

// No law of flow holds here; those of arithmetic do.
TEST_P(FullCell, HoldsUnderAnyForce) {
    std::mt19937 random(5);
    for (int paint = 0; paint < 100; ++paint) {
        Scene scene = wild_scene(GetParam(), random);
        scene.yield = std::max(0.0, scene.yield);
        scene.tan_receding = scene.tan_advancing = std::max(0.0, scene.tan_advancing);
        Bench bench(scene);
        std::uniform_real_distribution<double> thickness(0, kMaxThickness_mm), strength(0, 1090);
        bench.fill([&](int, int) { return thickness(random); });
        bench.tint(2, [&](int, int) { return strength(random); });
        const Totals before = totals(bench.state);
        for (int step = 0; step < 60; ++step)
            bench.solver->step(0.02);
        EXPECT_LE(thickest(bench), kMaxThickness_quanta) << paint;
        EXPECT_GE(channel_range(bench, 2).first, 0) << paint;
        Totals now = totals(bench.state);
        EXPECT_EQ(now.thickness + bench.solver->runoff().thickness, before.thickness) << paint;
        EXPECT_EQ(now.paint[2] + bench.solver->runoff().paint[2], before.paint[2]) << paint;
    }
}

INSTANTIATE_TEST_SUITE_P(Schemes, FullCell, testing::ValuesIn(all_schemes()),
                         [](const auto& test) { return test.param.name; });

}  // namespace
}  // namespace pastoso::film::test
