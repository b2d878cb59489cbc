// Paint that hardly moves waits for its step: it ends up where it would have without waiting, nothing is
// lost between tiles of different pace, and it is less work.
#include "film/film_bench.hpp"
#include "film/solver_state.hpp"
#include "film/tile_activity.hpp"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

namespace pastoso::film::test {
namespace {

constexpr double kTick_s = 1.0 / 60.0;
constexpr int kWidth = 640, kHeight = 192;

/// A slow sheet with a thick, faster blob that runs down through four tiles.
Scene sheet(Edge edge, double longest_wait_s, int threads = 1) {
    return {.width = kWidth,
            .height = kHeight,
            .cell_mm = 0.125,
            .gravity = 9000,
            .force_y = 3000,
            .viscosity = 2e4,
            .tension = 2.5e4,
            .edge_x = edge,
            .edge_y = edge,
            .full_curvature = true,
            .sleeping = true,
            .threads = threads,
            .solver = {.longest_wait_s = longest_wait_s}};
}

double ripples(int x, int y) {
    return 0.4 + 0.05 * std::sin(0.3 * x) * std::cos(0.2 * y) + blob(x, y, 130, 50, 30, 3.0);
}

/// The sheet after two seconds, tick by tick.
struct Outcome {
    Outcome(Edge edge, double longest_wait_s, int threads)
        : bench(sheet(edge, longest_wait_s, threads)) {
        bench.fill(ripples);
        bench.tint(1, [](int x, int y) { return 1.0 + 0.5 * std::sin(0.1 * x + 0.05 * y); });
        for (int tick = 0; tick < 120; ++tick)
            report.add(bench.solver->advance(kTick_s));
    }
    Bench bench;
    AdvanceReport report;
};

/// How far the lower edge of the blob has gone down, where it stands out of the ripples.
double way_of_front_mm(const Bench& bench) {
    int from = 0, to = 0;
    for (int y = 0; y < kHeight; ++y) {
        if (ripples(130, y) > 0.6) from = y;
        if (bench.h(130, y) > 0.6) to = y;
    }
    return (to - from) * 0.125;
}

TEST(Waiting, PaintGoesWhereItWouldHaveGone) {
    const Outcome punctual(Edge::Open, 0.0, 2);
    const Outcome waiting(Edge::Open, 1.0, 2);
    double moved_mm = 0.0, apart_mm = 0.0, furthest_mm = 0.0;
    for (int y = 0; y < kHeight; ++y)
        for (int x = 0; x < kWidth; ++x) {
            const double apart = std::abs(waiting.bench.h(x, y) - punctual.bench.h(x, y));
            moved_mm += std::abs(punctual.bench.h(x, y) - ripples(x, y));
            apart_mm += apart;
            furthest_mm = std::max(furthest_mm, apart);
        }
    // A tile may lag by as far as it may go unseen, which is as much of thickness on the blob's flanks,
    // whose slope is about one where they flow; what tiles dam up at their sides is much less. In all,
    // that is as large a share of what moved as the lag is of the way.
    const double unseen_mm = UnseenTravel(0.125).waiting_mm;
    EXPECT_LT(furthest_mm, unseen_mm);
    EXPECT_LT(apart_mm / moved_mm, unseen_mm / way_of_front_mm(punctual.bench));
    EXPECT_LT(waiting.report.cells_stepped, 0.5 * punctual.report.cells_stepped);
    // Groups of several paces: a step goes over half of the tiles on average at most.
    EXPECT_LT(waiting.report.cells_stepped, waiting.report.steps * (kWidth * kHeight / 2));
}

TEST(Waiting, WhatGoesUnseenIsALengthWhereCellsAreFine) {
    const UnseenTravel coarse(1.0), quarter(0.25), eighth(0.125), sixteenth(0.0625), hair(0.01);
    EXPECT_FLOAT_EQ(coarse.waiting_mm, 0.4F) << "of cells, where they are large";
    EXPECT_FLOAT_EQ(coarse.dammed_mm, 0.02F);
    EXPECT_FLOAT_EQ(coarse.at_rest_mm, 0.001F);
    EXPECT_FLOAT_EQ(coarse.waking_mm, 0.0005F);
    EXPECT_FLOAT_EQ(quarter.waiting_mm, 0.1F);
    for (const UnseenTravel& fine : {eighth, sixteenth})
        EXPECT_EQ(fine.dammed_mm, quarter.dammed_mm);
    EXPECT_EQ(eighth.waiting_mm, quarter.waiting_mm);
    EXPECT_FLOAT_EQ(sixteenth.waiting_mm, 0.8F * 0.0625F) << "a step carries paint by a cell at most";
    EXPECT_FLOAT_EQ(hair.waiting_mm, 0.8F * 0.01F) << "and four cells stand for one of them at most";
    EXPECT_FLOAT_EQ(hair.dammed_mm, 4.0F * 0.02F * 0.01F);
    EXPECT_FLOAT_EQ(hair.at_rest_mm, 1e-3F * 0.01F) << "what rests does not catch up";
    EXPECT_FLOAT_EQ(hair.waking_mm, 5e-4F * 0.01F);
}

class WaitingAtEdges : public testing::TestWithParam<Edge> {};

TEST_P(WaitingAtEdges, NothingIsLost) {
    Bench bench(sheet(GetParam(), 1.0));
    bench.fill(ripples);
    bench.tint(1, [](int x, int) { return 1.0 + 0.01 * x; });
    const Totals before = totals(bench.state);
    for (int tick = 0; tick < 100; ++tick) {
        if (tick % 10 == 3) bench.solver->wake({100 + tick, 60, 110 + tick, 70});
        bench.solver->advance(kTick_s);
    }
    const Totals after = totals(bench.state), runoff = bench.solver->runoff();
    EXPECT_EQ(after.thickness + runoff.thickness, before.thickness);
    for (int channel = 0; channel < kPaintChannels; ++channel)
        EXPECT_EQ(after.paint[channel] + runoff.paint[channel], before.paint[channel]) << channel;
}
INSTANTIATE_TEST_SUITE_P(Kinds, WaitingAtEdges, testing::Values(Edge::Open, Edge::Wall, Edge::Periodic),
                         [](const auto& test) { return name_of(test.param); });

TEST(Waiting, AnyNumberOfThreadsGivesTheSameBits) {
    const std::uint64_t reference = state_hash(Outcome(Edge::Open, 1.0, 1).bench.state);
    for (const int threads : {2, 3})
        EXPECT_EQ(state_hash(Outcome(Edge::Open, 1.0, threads).bench.state), reference);
}

TEST(Waiting, TimeGivenUpAndTakenAgainIsTheSame) {
    Outcome straight(Edge::Open, 1.0, 1);
    Outcome interrupted(Edge::Open, 1.0, 1);
    for (int tick = 0; tick < 8; ++tick) {
        straight.bench.solver->advance(kTick_s);
        int questions = 0;
        const auto impatient = [&] { return ++questions > 1; };
        if (!interrupted.bench.solver->advance_unless(impatient, kTick_s))
            interrupted.bench.solver->advance(kTick_s);
    }
    EXPECT_EQ(state_hash(interrupted.bench.state), state_hash(straight.bench.state));
}

/// Two tiles of one-millimetre cells, measured at 0.08 mm/s and 1 mm/s in the first second.
ActivityMap slow_beside_fast() {
    ActivityMap map({128, 64}, 1.0, false, false, false);
    map.wake(0);
    map.wake(1);
    map.let_pass(1.0, 8.0);
    map.begin_group();
    map.record(0, 1.0F, std::nullopt, {.seen_speed_mm_s = 0.08F}, {});
    map.record(1, 1.0F, std::nullopt, {.seen_speed_mm_s = 1.0F}, {});
    return map;
}

TEST(Waiting, APaceIsAPowerOfTwoOfCalls) {
    ActivityMap map = slow_beside_fast();
    for (int call = 2; call <= 3; ++call) {
        map.let_pass(1.0, 8.0);
        EXPECT_EQ(map.begin_group(), 1.0);
        EXPECT_EQ(map.stepping_tiles(), std::vector{1});
        EXPECT_FALSE(map.exchange(0, 1));  // the face waits for the slower tile
        EXPECT_FALSE(map.begin_group());
    }
    // 0.08 mm/s go 0.32 cells in four calls: the fourth call is due, after three that were missed.
    map.let_pass(1.0, 8.0);
    EXPECT_EQ(map.begin_group(), 1.0);
    EXPECT_EQ(map.begin_group(), 3.0);
    EXPECT_EQ(map.stepping_tiles(), std::vector{0});
    EXPECT_TRUE(map.exchange(0, 1));
    EXPECT_TRUE(map.exchange(1, 0));
    EXPECT_FALSE(map.begin_group());
}

TEST(Waiting, WhatArrivesFromANeighbourHurriesATile) {
    ActivityMap map = slow_beside_fast();
    map.let_pass(1.0, 8.0);
    map.begin_group();
    map.record(1, 1.0F, std::nullopt, {.seen_speed_mm_s = 1.0F}, {1.0F});
    map.let_pass(1.0, 8.0);
    EXPECT_EQ(map.begin_group(), 1.0);
    EXPECT_EQ(map.begin_group(), 2.0);
    EXPECT_EQ(map.stepping_tiles(), std::vector{0});
}

/// On which calls the left tile is stepped, when so much flows across the side between both.
std::vector<int> calls_of_the_slow_tile(float across_mm_s) {
    ActivityMap map = slow_beside_fast();
    SideSpeeds right{};
    right[kRight] = across_mm_s;
    std::vector<int> calls;
    for (int call = 2; call <= 12; ++call) {
        map.let_pass(1.0, 8.0);
        while (map.begin_group()) {
            if (!map.tile(0).stepping) continue;
            calls.push_back(call);
            map.record(0, 1.0F, std::nullopt, {.seen_speed_mm_s = 0.08F}, right);
        }
    }
    return calls;
}

TEST(Waiting, TilesThatExchangePaintKeepPace) {
    // In four calls 0.004 mm/s go less than a fiftieth of a cell, 0.008 mm/s only in two.
    EXPECT_EQ(calls_of_the_slow_tile(0.004F), (std::vector{4, 8, 12}));
    EXPECT_EQ(calls_of_the_slow_tile(0.008F), (std::vector{4, 6, 8, 10, 12}));
    EXPECT_EQ(calls_of_the_slow_tile(0.04F), (std::vector{4, 5, 6, 7, 8, 9, 10, 11, 12}));
}

TEST(Waiting, WhatIsNotSeenHurriesNoTile) {
    ActivityMap map({64, 64}, 1.0, false, false, false);
    map.wake(0);
    map.let_pass(1.0, 8.0);
    map.begin_group();
    map.record(0, 1.0F, std::nullopt, {.speed_mm_s = 20.0F, .seen_speed_mm_s = 0.08F}, {});
    for (int call = 2; call <= 4; ++call) {
        map.let_pass(1.0, 8.0);
        EXPECT_EQ(map.begin_group().has_value(), call == 4);
    }
}

/// The fastest flow of a step and the one that is seen, where even paint has a square bump.
FlowExtremes flow_of_bump(int cells) {
    Scene scene = sheet(Edge::Wall, 0.0);
    scene.width = scene.height = 64;
    scene.solver.scheme = Scheme::LargeStep;
    Bench bench(scene);
    bench.fill([&](int x, int y) {
        return x >= 20 && x < 20 + cells && y >= 20 && y < 20 + cells ? 1.5 : 0.4;
    });
    bench.solver->step(kTick_s);
    return bench.solver->state().awake.at(0).activity.extremes;
}

TEST(Waiting, PaintThatIsFastOnLessThanATenthOfASquareMillimetreIsNotSeen) {
    const FlowExtremes small = flow_of_bump(1), large = flow_of_bump(24);
    EXPECT_LT(small.seen_speed_mm_s, 0.7F * small.speed_mm_s);
    EXPECT_GT(large.seen_speed_mm_s, 0.7F * large.speed_mm_s);
    EXPECT_LE(large.seen_speed_mm_s, large.speed_mm_s);
}

TEST(Waiting, NoOneWaitsUnlessTold) {
    ActivityMap map = slow_beside_fast();
    map.let_pass(1.0, 0.0);
    EXPECT_EQ(map.begin_group(), 1.0);
    EXPECT_EQ(map.stepping_tiles(), (std::vector{0, 1}));
}

}  // namespace
}  // namespace pastoso::film::test
