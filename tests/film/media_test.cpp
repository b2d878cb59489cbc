// Films of several media: paint keeps the numbers of its own, mixtures have the means, and where tension
// differs it pulls. Densities are 1000 kg/m3 where nothing else is said.
#include "film/cell/wet_media.hpp"
#include "film/film_bench.hpp"
#include "film/schemes.hpp"
#include "film/validation/laws.hpp"

#include <cmath>
#include <numeric>
#include <random>

#include <gtest/gtest.h>

namespace pastoso::film::test {
namespace {

constexpr double kForce = 500.0;

/// Of all paint, quanta.
std::int64_t amount_of(const FilmState& state, int medium) {
    std::int64_t sum = 0;
    for (int y = 0; y < state.shape.height; ++y)
        for (int x = 0; x < state.shape.width; ++x) {
            const int own = state.media.own[state.shape.tile_at(x, y)];
            const MediaCell& cell = state.media.foreign.at(x, y);
            const std::int64_t foreign = std::accumulate(cell.begin(), cell.end(), std::int64_t{0});
            sum += own == medium ? state.thickness.at(x, y) - foreign : cell[medium];
        }
    return sum;
}

struct Media : testing::TestWithParam<Scheme> {
    Scene slope(double viscosity = 30.0) const {
        return {.width = 24,
                .height = 8,
                .force_y = kForce,
                .viscosity = viscosity,
                .lateral = false,
                .solver = GetParam().options};
    }
};

/// Nusselt's film with slip, mm/s: F h (h + 3 s) / (k_d nu), k_d = 6 / (3 alpha - 1).
double film_speed(double alpha, double slip_mm, double viscosity) {
    return kForce * (1.0 + 3.0 * slip_mm) * (3.0 * alpha - 1.0) / (6.0 * viscosity);
}

TEST_P(Media, EachPaintRunsByItsOwnProfileAndSlip) {
    const Scene scene = slope();
    Scene other = scene;
    other.alpha_min = other.alpha_max = 0.7;
    other.slip_cells = 0.4;
    Bench bench(scene);
    bench.fill([](int, int) { return 1.0; });
    bench.mix_in(medium_of(other), [](int x, int) { return x < 12 ? 0.0 : 1.0; });
    bench.run(0.005, 1.5);
    for (int x = 0; x < 24; ++x) {
        const double exact = x < 12 ? film_speed(1.0, 0.0, 30.0) : film_speed(0.7, 0.4, 30.0);
        EXPECT_NEAR(bench.v(x, 4), exact, 1e-4 * exact) << x;
    }
}

TEST_P(Media, EachPaintThinsByItsOwnIndex) {
    const Scene scene = slope();
    Scene other = scene;
    other.flow_index = 0.6;
    Bench bench(scene);
    bench.fill([](int, int) { return 1.0; });
    bench.mix_in(medium_of(other), [](int x, int) { return x < 12 ? 0.0 : 1.0; });
    bench.run(0.005, 1.5);
    const double thinned =
        validation::plastic_speed({.consistency = 30.0, .flow_index = 0.6}, kForce, 1.0);
    EXPECT_NEAR(bench.v(5, 4), film_speed(1.0, 0.0, 30.0), 1e-4 * film_speed(1.0, 0.0, 30.0));
    EXPECT_NEAR(bench.v(18, 4), thinned, 2e-3 * thinned);
}

TEST_P(Media, AMixtureHasTheMeansByVolume) {
    const Scene scene = slope();
    Scene other = scene;
    other.alpha_min = other.alpha_max = 0.7;
    Bench bench(scene);
    bench.fill([](int, int) { return 1.0; });
    bench.mix_in(medium_of(other), [](int, int) { return 0.25; });
    bench.run(0.005, 1.5);
    // The drags 3 and 6/1.1, three parts to one.
    const double exact = kForce / (30.0 * (0.75 * 3.0 + 0.25 * 6.0 / 1.1));
    EXPECT_NEAR(bench.v(7, 4), exact, 1e-3 * exact);
}

/// A film whose tension rises from left to right by so much a millimetre, within columns 8 to 55.
double pulled_speed(const Scheme& scheme, double slip_cells, double alpha, bool along_x) {
    constexpr int kLength = 64;
    Scene scene{.width = along_x ? kLength : 12,
                .height = along_x ? 12 : kLength,
                .viscosity = 400.0,
                .tension = 2000.0,
                .alpha_min = alpha,
                .alpha_max = alpha,
                .slip_cells = slip_cells,
                .lateral = false,
                .solver = scheme.options};
    Scene stronger = scene;
    stronger.tension = 2480.0;
    Bench bench(scene);
    bench.fill([](int, int) { return 0.5; });
    bench.mix_in(medium_of(stronger),
                 [&](int x, int y) { return std::clamp(((along_x ? x : y) - 7.5) / 48.0, 0.0, 1.0); });
    for (int step = 0; step < 20; ++step)
        bench.solver->step(1e-3);
    return along_x ? bench.u(32, 5) : bench.v(5, 32);
}

TEST_P(Media, TensionThatRisesPullsAFilmAlong) {
    // d(sigma)/dx / rho = 10 mm2/s2; a film is pulled at tau (h/2 + slip) / (rho nu).
    for (const bool along_x : {true, false})
        for (const double alpha : {1.0, 0.6})
            for (const double slip : {0.0, 0.3}) {
                const double exact = 10.0 * (0.25 + slip) / 400.0;
                EXPECT_NEAR(pulled_speed(GetParam(), slip, alpha, along_x), exact, 2e-3 * exact)
                    << "alpha " << alpha << ", slip " << slip;
            }
}

Scene drop_scene(const Scheme& scheme) {
    return {.width = 70,
            .height = 70,
            .gravity = 400,
            .force_x = 30,
            .force_y = 90,
            .viscosity = 40,
            .tension = 500,
            .yield = 10,
            .alpha_min = 0.8,
            .alpha_max = 1.2,
            .tan_advancing = 0.5,
            .tan_receding = 0.2,
            .slip_cells = 0.2,
            .edge_x = Edge::Wall,
            .edge_y = Edge::Wall,
            .solver = scheme.options};
}

Scene other_paint(Scene scene) {
    scene.tension = 380;
    scene.flow_index = 0.7;
    scene.alpha_min = scene.alpha_max = 1.0;
    scene.tan_advancing = 0.4;
    scene.tan_receding = 0.1;
    scene.slip_cells = 0.3;
    return scene;
}

double drop(double x, double y) {
    const double r = std::hypot(x - 30.5, y - 28.5) / 16.0;
    return r < 1.0 ? 3.0 * (1.0 - r * r) : 0.0;
}

double two_paints(int x, int y) {
    return x < 33 ? 1.0 : 0.02 * (y % 30);
}

TEST_P(Media, OfOneKindFlowAsThatKindAlone) {
    const Scene scene = drop_scene(GetParam());
    Scene same = scene;
    same.recovery_s = 5.0;  // which nothing depends on without structure
    Bench alone(scene), mixed(scene);
    alone.fill(drop);
    mixed.fill(drop);
    mixed.mix_in(medium_of(same), [](int x, int y) { return (3 * x + 5 * y) % 7 / 6.0; });
    alone.pass(0.25);
    mixed.pass(0.25);
    const double moved = alone.largest_difference(drop);
    const double largest = alone.largest_difference([&](int x, int y) { return mixed.h(x, y); });
    EXPECT_GT(moved, 0.2);
    // The thinning law for n = 1 is right to 1e-6; what a line lets through depends on a threshold.
    EXPECT_LT(largest, 0.01 * moved);
}

TEST_P(Media, AreKeptWhereverPaintFlows) {
    const Scene scene = drop_scene(GetParam());
    Bench bench(scene);
    bench.fill(drop);
    bench.mix_in(medium_of(other_paint(scene)), [](int x, int) { return x < 33 ? 1.0 : 0.1; });
    const std::int64_t before[2] = {amount_of(bench.state, 0), amount_of(bench.state, 1)};
    const std::int64_t all = totals(bench.state).thickness;
    bench.pass(1.0);
    EXPECT_EQ(totals(bench.state).thickness, all);
    for (const int medium : {0, 1}) {
        // Amounts are moved a hair below their share, 1e-6 of what passes.
        EXPECT_NEAR(amount_of(bench.state, medium), before[medium], 2e-4 * before[medium]) << medium;
    }
    for (int y = 0; y < 70; ++y)
        for (int x = 0; x < 70; ++x) {
            const MediaCell& cell = bench.state.media.foreign.at(x, y);
            EXPECT_LE(std::accumulate(cell.begin(), cell.end(), std::int64_t{0}),
                      bench.state.thickness.at(x, y));
        }
}

TEST_P(Media, KeepTheirNumbersWhenAnotherIsTakenInHand) {
    const Scene scene = drop_scene(GetParam());
    Bench left(scene), taken(scene);
    left.fill(drop);
    taken.fill(drop);
    const Medium other = medium_of(other_paint(scene));
    add_medium(taken.state, film_numbers_of(other));
    taken.solver->set_medium(other);
    left.pass(0.4);
    taken.pass(0.4);
    for (int y = 0; y < 70; ++y)
        for (int x = 0; x < 70; ++x)
            ASSERT_EQ(left.state.thickness.at(x, y), taken.state.thickness.at(x, y));
}

TEST_P(Media, AreTheSameOnAnyNumberOfThreads) {
    Scene scene = drop_scene(GetParam());
    Bench bench(scene);
    scene.threads = 3;
    Bench other(scene);
    for (Bench* each : {&bench, &other}) {
        each->fill(drop);
        each->mix_in(medium_of(other_paint(scene)), two_paints);
        each->pass(0.3);
    }
    EXPECT_EQ(state_hash(bench.state), state_hash(other.state));
}

TEST_P(Media, AreTheSameTurned) {
    const Scene scene = drop_scene(GetParam());
    Scene turned = scene;
    std::swap(turned.force_x, turned.force_y);
    Bench bench(scene), other(turned);
    bench.fill(drop);
    other.fill([](int x, int y) { return drop(y, x); });
    bench.mix_in(medium_of(other_paint(scene)), two_paints);
    other.mix_in(medium_of(other_paint(turned)), [&](int x, int y) { return two_paints(y, x); });
    bench.pass(0.3);
    other.pass(0.3);
    double apart = 0.0;
    for (int y = 0; y < 70; ++y)
        for (int x = 0; x < 70; ++x)
            apart += std::abs(bench.h(x, y) - other.h(y, x));
    EXPECT_LE(apart, GetParam().turning_error * bench.volume());
}

/// The thickness in the middle of a film of 0.3 mm, 0.5 s after the paint there got another tension.
double middle_mm(const Scheme& scheme, double tension_in_the_middle) {
    const Scene scene{.width = 60,
                      .height = 60,
                      .cell_mm = 0.25,
                      .gravity = 1000,
                      .viscosity = 20,
                      .tension = 1000,
                      .edge_x = Edge::Wall,
                      .edge_y = Edge::Wall,
                      .solver = scheme.options};
    Scene other = scene;
    other.tension = tension_in_the_middle;
    Bench bench(scene);
    bench.fill([](int, int) { return 0.3; });
    bench.mix_in(medium_of(other),
                 [](int x, int y) { return std::hypot(x - 29.5, y - 29.5) < 8 ? 1.0 : 0.0; });
    bench.pass(0.5);
    return bench.h(29, 29);
}

TEST_P(Media, LowerTensionDrivesAFilmApartAndHigherHeapsItUp) {
    EXPECT_LT(middle_mm(GetParam(), 960), 0.28);
    EXPECT_GT(middle_mm(GetParam(), 1040), 0.32);
}

/// By how much a square root of time, from 4 to 16 s, the line between two halves of a film moves whose
/// left one has a lower tension, mm/s^(1/2).
double front_rate(const Scheme& scheme, double cell_mm) {
    const int width = static_cast<int>(std::lround(40 / cell_mm));
    const Scene scene{.width = width,
                      .height = 4,
                      .cell_mm = cell_mm,
                      .gravity = 1000,
                      .viscosity = 20,
                      .tension = 50,
                      .edge_x = Edge::Wall,
                      .inertia = false,
                      .lateral = false,
                      .solver = scheme.options};
    Scene weak = scene;
    weak.tension = 10;
    Bench bench(scene);
    bench.fill([](int, int) { return 0.3; });
    bench.mix_in(medium_of(weak), [&](int x, int) { return x < width / 2 ? 1.0 : 0.0; });
    const auto share = [&](int x) {
        return bench.state.media.foreign.at(x, 2)[1] /
               static_cast<double>(bench.state.thickness.at(x, 2));
    };
    const auto line_mm = [&] {
        int x = width / 2;
        while (share(x) > 0.5)
            ++x;
        return (x + (share(x - 1) - 0.5) / (share(x - 1) - share(x))) * cell_mm;
    };
    bench.pass(4.0);
    const double first_mm = line_mm();
    bench.pass(12.0);
    return (line_mm() - first_mm) / (std::sqrt(16.0) - std::sqrt(4.0));
}

TEST_P(Media, AFrontOfLowerTensionGoesOutWithTheRootOfTime) {
    const double exact =
        validation::TensionFront{.gravity = 1000, .tension_step = 40, .viscosity = 20, .h = 0.3}.rate();
    // Tension bends the film in front and behind for 0.2 mm, where the exact front has a step: 6 and, in
    // cells half as large, 4 % short.
    EXPECT_NEAR(front_rate(GetParam(), 0.25), exact, 0.07 * exact);
    if (GetParam().options.scheme == film::Scheme::LargeStep) {
        EXPECT_NEAR(front_rate(GetParam(), 0.125), exact, 0.05 * exact);
    }
}

INSTANTIATE_TEST_SUITE_P(Schemes, Media, testing::ValuesIn(all_schemes()),
                         [](const auto& scheme) { return scheme.param.name; });

TEST(WetMedia, MoreThanThereIsRoomForBecomeTheMostAlike) {
    Bench bench({.width = 70, .height = 70});
    bench.fill([](int x, int y) { return 64 * y + x < 20 ? 1.0 : 0.0; });
    Medium medium = medium_of(bench.setup);
    for (int k = 1; k <= kMostMedia; ++k) {
        medium.surface_tension_N_m = k == 9 ? 0.0401 : 0.03 + 0.01 * k;
        const int place = add_medium(bench.state, film_numbers_of(medium));
        ASSERT_LT(place, kMostMedia);
        MediaCell cell{};
        cell[place] = bench.state.thickness.at(k, 0) / 2;
        bench.state.media.foreign.set(k, 0, cell);
    }
    EXPECT_EQ(bench.state.media.numbers.size(), kMostMedia);
    // 0.0401 and 0.04 have become one; each cell still has half its paint of some other medium.
    const double numbers = mixed_number(bench.state, 0, 9, &FilmNumbers::surface_tension_N_m);
    EXPECT_NEAR(numbers, 0.5 * 0.04 + 0.5 * bench.state.media.numbers[0].surface_tension_N_m, 1e-4);
    for (int k = 1; k <= kMostMedia; ++k) {
        const MediaCell& cell = bench.state.media.foreign.at(k, 0);
        EXPECT_EQ(std::accumulate(cell.begin(), cell.end(), 0), bench.state.thickness.at(k, 0) / 2);
    }
}

TEST(WetMedia, ATileOfAnotherMediumAloneNeedsNoCells) {
    Bench bench({.width = 70, .height = 70});
    bench.fill([](int x, int) { return x < 64 ? 0.4 : 0.0; });
    bench.mix_in(validation::medium_of({.width = 70, .height = 70, .tension = 20.0}),
                 [](int, int y) { return y < 64 ? 1.0 : 0.5; });
    const int tiles = bench.state.shape.tile_count();
    for (int tile = 0; tile < tiles; ++tile)
        settle_media(bench.state, tile);
    EXPECT_FALSE(bench.state.media.is_mixed(0));
    EXPECT_EQ(bench.state.media.own[0], 1);
    EXPECT_TRUE(bench.state.media.is_mixed(2));
}

}  // namespace
}  // namespace pastoso::film::test
