// Laws that hold for any paint, tried on white noise with random properties: 240 fixed seeds for
// each scheme, and as many others and fresh ones in the long set (long_property_test.cpp).
#include "film/random_paint.hpp"

#include <cmath>
#include <random>

#include <gtest/gtest.h>

namespace pastoso::film::test {
namespace {

class AnyPaint : public testing::TestWithParam<PaintCase> {};

TEST_P(AnyPaint, StaysFiniteExactAndCalm) {
    const auto& [scheme, edges] = GetParam();
    const auto first_seed = static_cast<std::uint32_t>(1000 * (1 + static_cast<int>(edges)));
    expect_calm(run_random_paints(
        scheme, edges,
        {.first_seed = first_seed, .count = scheme.random_paints, .steps = scheme.random_steps}));
}
INSTANTIATE_TEST_SUITE_P(Schemes, AnyPaint, testing::ValuesIn(all_paint_cases()),
                         [](const auto& test) { return name_of(test.param); });

/// Sweeps that a large step of thick noise takes, so thin-bodied that its surface answers as one from
/// edge to edge of a small canvas.
int sweeps_of_thick_noise(std::uint32_t seed, Edge edge_x) {
    Scene scene{.width = 40,
                .height = 40,
                .gravity = 2.0,
                .viscosity = 0.2,
                .tension = 8.0,
                .yield = 1.3,
                .edge_x = edge_x,
                .edge_y = Edge::Wall,
                .full_curvature = true};
    scene.solver.scheme = film::Scheme::LargeStep;
    Bench bench(scene);
    std::mt19937 random(seed);
    bench.fill([&](int, int) { return 5.0 * std::uniform_real_distribution<double>()(random); });
    const AdvanceReport report = bench.solver->step(0.8);
    EXPECT_EQ(report.rejected_steps, 0);
    EXPECT_LE(bench.max_h(), 8.0);
    EXPECT_LE(report.largest_speed_mm_s, 10.0);
    return report.sweeps;
}

// Nothing answers beyond an open edge. A patch that lets the cells there take up paint swings ever
// further, by a factor of two with each sweep.
TEST(ThickNoise, IsSolvedBesideOpenEdgesAsBesideWalls) {
    for (const std::uint32_t seed : {1, 2, 3, 4, 5})
        EXPECT_LE(sweeps_of_thick_noise(seed, Edge::Open), 2 * sweeps_of_thick_noise(seed, Edge::Wall))
            << seed;
}

/// Eight tiles in a row: paint with ripples in the first two, and in the last two, where `with_thin`
/// says so, drops on a steep canvas of which many cells run empty in a step.
struct RippleAndThinFilm {
    explicit RippleAndThinFilm(bool with_thin) : bench(scene()) {
        std::mt19937 random(1);
        bench.fill([&](int x, int y) {
            const double noise = std::uniform_real_distribution<double>()(random);
            if (x < 120) return 0.3 + 0.1 * std::sin(0.4 * x) * std::cos(0.3 * y);
            return with_thin && x >= 400 && noise > 0.7 ? 0.2 * noise : 0.0;
        });
        report = bench.solver->step(1.0 / 60.0);
    }
    static Scene scene() {
        Scene scene{.width = 512,
                    .height = 64,
                    .cell_mm = 0.125,
                    .gravity = 9000,
                    .force_y = 5000,
                    .viscosity = 50.0,
                    .tension = 2.5e4,
                    .edge_x = Edge::Wall,
                    .edge_y = Edge::Wall};
        scene.solver.scheme = film::Scheme::LargeStep;
        return scene;
    }
    Bench bench;
    AdvanceReport report;
};

TEST(Supply, CellsThatRunEmptyChangeNothingFarAway) {
    const RippleAndThinFilm alone(false), beside(true);
    EXPECT_GT(beside.report.sweeps, alone.report.sweeps + 3) << "cells did run empty";
    for (int y = 0; y < 64; ++y)
        for (int x = 0; x < 256; ++x)
            ASSERT_EQ(beside.bench.state.thickness.at(x, y), alone.bench.state.thickness.at(x, y))
                << x << ", " << y;
}

}  // namespace
}  // namespace pastoso::film::test
