// A lake at rest: paint with a level surface over any support that is a multiple of the quantum of
// supports, so that floats hold depth, ground and level exactly. It must not move at all.
#include "film/film_bench.hpp"
#include "film/schemes.hpp"
#include "film/support/support.hpp"

#include <algorithm>
#include <cmath>
#include <random>
#include <tuple>
#include <utility>

#include <gtest/gtest.h>

namespace pastoso::film::test {
namespace {

constexpr int kSide = 96;
constexpr double kCell_mm = 0.25;

Scene lake_scene(const Scheme& scheme) {
    return {.width = kSide,
            .height = kSide,
            .cell_mm = kCell_mm,
            .gravity = 9810,
            .viscosity = 50,
            .tension = 2.5e4,
            .edge_x = Edge::Wall,
            .full_curvature = true,
            .solver = scheme.options};
}

/// Fills up to the level, rounded to the quantum of supports.
void flood(double level_mm, Bench& bench) {
    const double level = std::round(level_mm / kSupportQuantum_mm) * kSupportQuantum_mm;
    bench.fill([&](int x, int y) { return std::max(0.0, level - bench.state.support_mm.at(x, y)); });
}

void expect_still(const Scheme& scheme, Bench& bench, double depth_mm) {
    const std::uint64_t before = state_hash(bench.state);
    const double dt = scheme.step_in_limits * bench.solver->stable_step_s(depth_mm);
    for (int step = 0; step < 500; ++step)
        bench.solver->step(dt);
    EXPECT_EQ(state_hash(bench.state), before);
    bench.solver->advance(20 * dt);
    EXPECT_EQ(state_hash(bench.state), before);
}

double highest(const Bench& bench) {
    double height = 0;
    for (int y = 0; y < kSide; ++y)
        for (int x = 0; x < kSide; ++x)
            height = std::max<double>(height, bench.state.support_mm.at(x, y));
    return height;
}

void lay_noise(double relief_mm, Bench& bench) {
    std::mt19937 random(11);
    std::uniform_int_distribution<int> quanta(0, static_cast<int>(relief_mm / kSupportQuantum_mm));
    bench.set_support([&](int, int) { return quanta(random) * kSupportQuantum_mm; });
}

using WovenCase = std::tuple<Scheme, const char*>;
class LakeOverCloth : public testing::TestWithParam<WovenCase> {};

TEST_P(LakeOverCloth, DoesNotMove) {
    const auto& [scheme, cloth] = GetParam();
    for (const bool yields : {false, true}) {
        Scene scene = lake_scene(scheme);
        scene.yield = yields ? 1e3 : 0.0;
        scene.alpha_min = yields ? 0.5 : 1.0;
        Bench bench(scene);
        core::ThreadPool pool(1);
        bench.state.support_mm = named_support(cloth, bench.state.shape, kCell_mm, 0.0, pool);
        ASSERT_GT(highest(bench), 0.01);
        flood(highest(bench) + 0.2, bench);
        expect_still(scheme, bench, 0.5);
    }
}
INSTANTIATE_TEST_SUITE_P(Supports, LakeOverCloth,
                         testing::Combine(testing::ValuesIn(all_schemes()),
                                          testing::Values("linen", "cotton duck", "panel")),
                         [](const auto& test) {
                             const std::string cloth = std::get<1>(test.param);
                             return std::get<0>(test.param).name + cloth.substr(0, cloth.find(' '));
                         });

class Lake : public testing::TestWithParam<Scheme> {};

TEST_P(Lake, OverWhiteNoiseDoesNotMove) {
    Bench bench(lake_scene(GetParam()));
    lay_noise(0.6, bench);
    flood(1.0, bench);
    expect_still(GetParam(), bench, 1.0);
}

// Peaks that stand out of the lake are dry land: without tension, which would draw a meniscus up to
// them, nothing moves either.
TEST_P(Lake, BetweenIslandsDoesNotMove) {
    Scene scene = lake_scene(GetParam());
    scene.tension = 0;
    Bench bench(scene);
    lay_noise(0.6, bench);
    flood(0.4, bench);
    ASSERT_GT(std::count_if(bench.state.thickness.read(0), bench.state.thickness.read(0) + 64,
                            [](std::int32_t quanta) { return quanta == 0; }),
              5);
    expect_still(GetParam(), bench, 0.4);
}
// Cells of a tile beyond the canvas do not count: nothing bounds the step of a lake that stands still.
TEST_P(Lake, OfAnySizeIsPassedInOneStep) {
    for (const auto& [width, height] : {std::pair{64, 64}, {96, 96}, {70, 33}, {128, 128}})
        for (const Edge edge : {Edge::Wall, Edge::Periodic}) {
            Scene scene = lake_scene(GetParam());
            scene.width = width;
            scene.height = height;
            scene.edge_x = edge;
            scene.edge_y = edge;
            Bench bench(scene);
            bench.fill([](int, int) { return 1.0; });
            bench.solver->advance(0.01);  // wakes with the step of any paint that deep
            EXPECT_EQ(bench.solver->advance(1.0).steps, 1)
                << width << " x " << height << ' ' << name_of(edge);
        }
}
INSTANTIATE_TEST_SUITE_P(Schemes, Lake, testing::ValuesIn(all_schemes()),
                         [](const auto& test) { return test.param.name; });

}  // namespace
}  // namespace pastoso::film::test
