// What must hold for any paint: nothing is lost, nothing goes negative, directions and thread counts do
// not matter, still paint stays still.
#include "film/film_bench.hpp"
#include "film/schemes.hpp"

#include <algorithm>
#include <cmath>
#include <random>

#include <gtest/gtest.h>

namespace pastoso::film::test {
namespace {

std::int32_t smallest_thickness(const FilmState& state) {
    std::int32_t smallest = 0;
    for (int y = 0; y < state.shape.height; ++y)
        for (int x = 0; x < state.shape.width; ++x)
            smallest = std::min(smallest, state.thickness.at(x, y));
    return smallest;
}

std::int32_t smallest_channel(const FilmState& state) {
    std::int32_t smallest = 0;
    for (int y = 0; y < state.shape.height; ++y)
        for (int x = 0; x < state.shape.width; ++x)
            for (const std::int32_t channel : state.paint.at(x, y))
                smallest = std::min(smallest, channel);
    return smallest;
}

Scene runny_with(Edge edge) {
    Scene scene = runny(90, 70);
    scene.edge_x = scene.edge_y = edge;
    return scene;
}

class AnyEdge : public testing::TestWithParam<Edge> {};

TEST_P(AnyEdge, VolumeAndAllThatPaintCarriesAreExact) {
    Bench bench(runny_with(GetParam()));
    bench.fill([](int x, int y) { return blob(x, y, 60, 30, 22, 4) + (x < 20 ? 0.4 : 0.0); });
    bench.tint(0, [](int x, int) { return x < 60 ? 100.0 : 3.0; });
    bench.tint(7, [](int, int y) { return y < 30 ? 0.01 : 180.0; });
    for (int k = kPigmentChannels; k < kPaintChannels; ++k)
        bench.tint(k, [k](int x, int y) { return 0.2 * k + (x < y ? 3.0 : 0.0); });
    const Totals before = totals(bench.state);
    bench.run(0.04, 60.0);
    Totals after = totals(bench.state);
    after.thickness += bench.solver->runoff().thickness;
    EXPECT_EQ(after.thickness, before.thickness);
    for (int k = 0; k < kPaintChannels; ++k)
        EXPECT_EQ(after.paint[k] + bench.solver->runoff().paint[k], before.paint[k]) << k;
    EXPECT_GE(smallest_thickness(bench.state), 0);
    EXPECT_GE(smallest_channel(bench.state), 0);
    EXPECT_EQ(bench.solver->runoff().thickness > 0, GetParam() == Edge::Open);
}
INSTANTIATE_TEST_SUITE_P(Edges, AnyEdge, testing::Values(Edge::Periodic, Edge::Wall, Edge::Open),
                         [](const auto& test) { return name_of(test.param); });

// Pigment moves with the paint: a uniform concentration stays uniform.
TEST(Pigment, UniformColourStaysUniform) {
    Bench bench(runny_with(Edge::Periodic));
    bench.fill([](int x, int y) { return 0.5 + blob(x, y, 45, 35, 25, 3); });
    bench.tint(3, [](int, int) { return 40.0; });
    bench.run(0.04, 40.0);
    for (int y = 0; y < 70; ++y)
        for (int x = 0; x < 90; ++x) {
            const double concentration =
                optical_thickness(bench.state.paint.at(x, y)[3]) / bench.h(x, y);
            // What stays behind by rule, one part in a million a step, adds up to less than this.
            ASSERT_NEAR(concentration, 40.0, 0.02) << x << ' ' << y;
        }
}

// Force and shape mirrored give the mirrored film, to the bit: every formula treats both sides alike.
TEST(Symmetry, MirroredInputGivesMirroredFilm) {
    Scene scene = runny_with(Edge::Wall);
    const auto shape = [](int x, int y) {
        return blob(x, y, 30, 30, 18, 3.5) + blob(x, y, 70, 50, 9, 1);
    };
    Bench straight(scene);
    straight.fill(shape);
    straight.run(0.04, 24.0);
    scene.force_x = -scene.force_x;
    Bench mirrored(scene);
    mirrored.fill([&](int x, int y) { return shape(89 - x, y); });
    mirrored.run(0.04, 24.0);
    for (int y = 0; y < 70; ++y)
        for (int x = 0; x < 90; ++x)
            ASSERT_EQ(straight.state.thickness.at(x, y), mirrored.state.thickness.at(89 - x, y))
                << x << ' ' << y;
}

TEST(Symmetry, TransposedInputGivesTransposedFilm) {
    Scene scene = runny_with(Edge::Wall);
    scene.width = scene.height = 80;
    const auto shape = [](int x, int y) {
        return blob(x, y, 30, 36, 18, 3.5) + blob(x, y, 60, 50, 9, 1);
    };
    Bench straight(scene);
    straight.fill(shape);
    straight.run(0.04, 24.0);
    std::swap(scene.force_x, scene.force_y);
    Bench transposed(scene);
    transposed.fill([&](int x, int y) { return shape(y, x); });
    transposed.run(0.04, 24.0);
    for (int y = 0; y < 80; ++y)
        for (int x = 0; x < 80; ++x)
            ASSERT_EQ(straight.state.thickness.at(x, y), transposed.state.thickness.at(y, x))
                << x << ' ' << y;
}

// Still paint over any support: exactly still when heights are on the quantum grid.
TEST(LakeAtRest, StaysExactlyStill) {
    Bench bench({.width = 64, .height = 64, .gravity = 10, .viscosity = 0.1, .tension = 5});
    std::mt19937 random(1);
    std::uniform_int_distribution<int> height(300000, 900000);
    bench.set_support([&](int, int) { return height(random) * 0x1p-20; });
    bench.fill([&](int x, int y) { return 2.0 - bench.state.support_mm.at(x, y); });
    const std::uint64_t before = state_hash(bench.state);
    bench.run(0.02, 40.0);
    EXPECT_EQ(state_hash(bench.state), before);
}

TEST(LakeAtRest, OnAnySupportRoundingIsAllThatMoves) {
    Bench bench({.width = 64, .height = 64, .gravity = 10, .viscosity = 0.1, .tension = 5});
    std::mt19937 random(1);
    std::uniform_real_distribution<double> height(0.3, 0.9);
    bench.set_support([&](int, int) { return height(random); });
    bench.fill([&](int x, int y) { return 2.0 - bench.state.support_mm.at(x, y); });
    const FilmState before = bench.state;
    bench.run(0.02, 200.0);
    double largest = 0;
    for (int y = 0; y < 64; ++y)
        for (int x = 0; x < 64; ++x)
            largest = std::max<double>(largest, std::abs(thickness_mm(bench.state.thickness.at(x, y) -
                                                                      before.thickness.at(x, y))));
    EXPECT_LT(largest, 1e-5);  // single precision of a 2 mm surface is 2e-7
}

// advance() chooses its steps: paint that drips must not be clamped, and the result must agree with much
// smaller steps.
TEST(StepLength, ChosenStepsAgreeWithSmallOnes) {
    Scene scene = runny_with(Edge::Open);
    const auto shape = [](int x, int y) { return blob(x, y, 40, 30, 20, 3); };
    Bench chosen(scene);
    chosen.fill(shape);
    AdvanceReport report;
    for (int tick = 0; tick < 120; ++tick)
        report.add(chosen.solver->advance(0.1));
    Bench fine(scene);
    fine.fill(shape);
    fine.run(0.004, 12.0);
    double difference = 0;
    for (int y = 0; y < 70; ++y)
        for (int x = 0; x < 90; ++x)
            difference += std::abs(chosen.h(x, y) - fine.h(x, y));
    EXPECT_EQ(report.clamped_faces, 0);
    EXPECT_LT(difference / fine.volume(), 0.02);  // first order in time
    EXPECT_LT(report.steps, 1500);
}

Scene stiff() {
    return {.width = 256,
            .height = 128,
            .cell_mm = 0.25,
            .gravity = 4900,
            .force_y = 8500,
            .viscosity = 3e4,
            .tension = 2.3e4,
            .yield = 1.3e4,
            .tan_advancing = 0.6,
            .tan_receding = 0.2,
            .slip_cells = 0.2,
            .edge_x = Edge::Open,
            .edge_y = Edge::Open,
            .sleeping = true};
}

TEST(Sleep, StiffPaintComesToRestAndWakes) {
    Bench bench(stiff());
    bench.fill([](int x, int y) { return blob(x, y, 128, 64, 30, 1.0); });
    EXPECT_GT(bench.solver->awake_tile_count(), 0);
    bench.solver->advance(3.0);
    EXPECT_EQ(bench.solver->awake_tile_count(), 0);
    const std::uint64_t at_rest = state_hash(bench.state);
    EXPECT_EQ(bench.solver->advance(1.0).steps, 0);
    EXPECT_EQ(state_hash(bench.state), at_rest);
    bench.solver->wake({100, 60, 110, 70});
    EXPECT_GT(bench.solver->awake_tile_count(), 0);
}

// Paint that flows into sleeping tiles wakes them, and loses nothing on the way.
TEST(Sleep, FlowCrossesIntoSleepingTiles) {
    Scene scene = stiff();
    scene.yield = 0;
    scene.viscosity = 600;
    scene.tan_advancing = 0.3;
    Bench sleeping(scene);
    const auto shape = [](int x, int y) { return blob(x, y, 96, 43, 20, 0.8); };
    sleeping.fill(shape);
    scene.sleeping = false;
    Bench watched(scene);
    watched.fill(shape);
    const std::int64_t before = totals(sleeping.state).thickness;
    for (int tick = 0; tick < 45; ++tick) {
        sleeping.solver->advance(1.0 / 60);
        watched.solver->advance(1.0 / 60);
    }
    double difference = 0, below = 0;
    for (int y = 0; y < 128; ++y)
        for (int x = 0; x < 256; ++x) {
            difference += std::abs(sleeping.h(x, y) - watched.h(x, y));
            below += y >= 64 ? sleeping.h(x, y) : 0.0;
        }
    EXPECT_EQ(totals(sleeping.state).thickness + sleeping.solver->runoff().thickness, before);
    EXPECT_GT(below, 0.0);
    EXPECT_LT(difference / watched.volume(), 0.01);  // a tile wakes a ten-thousandth of a cell late
}

// Giving up leaves everything as it was: the same time then passes as if nothing had happened.
class Abandon : public testing::TestWithParam<Scheme> {};

TEST_P(Abandon, LeavesNoTrace) {
    Scene scene = runny_with(Edge::Open);
    scene.solver = GetParam().options;
    const auto shape = [](int x, int y) { return blob(x, y, 40, 40, 25, 3); };
    Bench straight(scene), interrupted(scene);
    straight.fill(shape);
    interrupted.fill(shape);
    const std::uint64_t before = state_hash(interrupted.state);
    int questions = 0;
    EXPECT_FALSE(interrupted.solver->advance_unless([&] { return ++questions > 7; }, 20.0).has_value());
    EXPECT_EQ(questions, 8);
    EXPECT_EQ(state_hash(interrupted.state), before);

    EXPECT_TRUE(interrupted.solver->advance_unless([] { return false; }, 2.0).has_value());
    straight.solver->advance(2.0);
    EXPECT_EQ(state_hash(interrupted.state), state_hash(straight.state));
    EXPECT_EQ(interrupted.solver->runoff().thickness, straight.solver->runoff().thickness);
}
INSTANTIATE_TEST_SUITE_P(Schemes, Abandon, testing::ValuesIn(all_schemes()),
                         [](const auto& test) { return test.param.name; });

}  // namespace
}  // namespace pastoso::film::test
