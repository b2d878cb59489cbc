#include "film/random_paint.hpp"

#include "film/film_bench.hpp"

#include <cmath>
#include <random>

#include <gtest/gtest.h>

namespace pastoso::film::test {
namespace {

struct RandomPaint {
    explicit RandomPaint(std::uint32_t seed) : random(seed) {
        scene.width = scene.height = 40;
        scene.gravity = decades(0.1, 20);
        scene.viscosity = decades(1e-2, 100);
        scene.tension = decades(0.1, 50);
        scene.yield = uniform() < 0.5 ? decades(0.01, 3) : 0.0;
        scene.force_x = uniform() * scene.gravity;
        scene.force_y = (uniform() - 0.5) * scene.gravity;
        scene.tan_advancing = uniform() < 0.5 ? 0.2 + uniform() : 0.0;
        scene.tan_receding = 0.5 * scene.tan_advancing;
        scene.alpha_min = 0.5 + 0.5 * uniform();
        scene.alpha_max = scene.alpha_min + 0.5 * uniform();
        scene.full_curvature = uniform() < 0.5;
        scene.edge_x = scene.edge_y = static_cast<Edge>(random() % 3);
        thickness = decades(0.2, 5);
    }
    double uniform() { return std::uniform_real_distribution<double>()(random); }
    double decades(double low, double high) { return low * std::pow(high / low, uniform()); }
    std::mt19937 random;
    Scene scene;
    double thickness = 1;
};

void expect_sound(const Bench& bench, double largest_start, std::uint32_t seed) {
    // Against a wall paint piles up by nature.
    if (bench.scene.edge_x != Edge::Wall) {
        EXPECT_LT(bench.max_h(), 8 * largest_start) << seed;
    }
    for (int y = 0; y < bench.scene.height; ++y)
        for (int x = 0; x < bench.scene.width; ++x) {
            ASSERT_GE(bench.state.thickness.at(x, y), 0) << seed;
            ASSERT_TRUE(std::isfinite(bench.u(x, y) + bench.v(x, y))) << seed;
        }
}

}  // namespace

bool run_random_paint(std::uint32_t seed, int steps) {
    RandomPaint paint(seed);
    Bench bench(paint.scene);
    bench.set_support([&](int, int) { return 0.3 * paint.thickness * paint.uniform(); });
    bench.fill(
        [&](int, int) { return paint.uniform() < 0.7 ? 2 * paint.thickness * paint.uniform() : 0.0; });
    const std::int64_t before = totals(bench.state).thickness;
    const double dt = 0.5 * bench.solver->stable_step_s(2 * paint.thickness);
    bench.run(dt, 20 * dt);
    AdvanceReport report;
    for (int i = 0; i < steps; ++i)
        report.add(bench.solver->advance(dt));
    EXPECT_EQ(totals(bench.state).thickness + bench.solver->runoff().thickness, before) << seed;
    expect_sound(bench, 2 * paint.thickness, seed);
    return report.clamped_faces > 0;
}

}  // namespace pastoso::film::test
