// Paint whose cells differ in viscosity and yield stress. A density of 1000 kg/m3 makes a pascal 1000
// mm2/s2.
#include "film/cell/drying.hpp"
#include "film/dry_film.hpp"
#include "film/explicit/tile_step.hpp"
#include "film/film_bench.hpp"

#include <algorithm>
#include <cmath>
#include <random>

#include <gtest/gtest.h>

namespace pastoso::film::test {
namespace {

constexpr double kForce = 500.0;

/// A slab of 1 mm on a slope; columns of cells do not drag at each other.
Scene slope() {
    return {.width = 24, .height = 8, .force_y = kForce, .alpha_min = 1.0, .lateral = false};
}

/// Gives every cell its viscosity (mm2/s) and yield stress (mm2/s2).
void set_rheology(Bench& bench, const std::function<double(int, int)>& viscosity,
                  const std::function<double(int, int)>& yield) {
    bench.tint(kViscosityChannel, [&](int x, int y) { return std::log(viscosity(x, y)); });
    bench.tint(kYieldChannel, [&](int x, int y) { return 1e-3 * yield(x, y); });
    bench.state.consistencies = film::Consistencies::several();
}

/// Mean velocity of a Bingham film of 1 mm under kForce.
double film_velocity(double viscosity, double yield) {
    const double plug = std::min(1.0, yield / kForce);
    return kForce / (3.0 * viscosity) * (1.0 - plug) * (1.0 - plug) * (1.0 + 0.5 * plug);
}

TEST(VariedPaint, GlazeRunsBesideOilThatStands) {
    Bench bench(slope());
    bench.fill([](int, int) { return 1.0; });
    set_rheology(
        bench, [](int x, int) { return x < 12 ? 30.0 : 900.0; },
        [](int x, int) { return x < 12 ? 0.0 : 1.01 * kForce; });
    bench.run(0.01, 2.0);
    for (int x = 0; x < 24; ++x) {
        const double exact = x < 12 ? film_velocity(30.0, 0.0) : 0.0;
        // The viscosity is carried to 2^-18 mm, 4e-6 of its logarithm, and computed to 1e-6.
        EXPECT_NEAR(bench.v(x, 4), exact, 1e-4 * exact) << x;
    }
}

TEST(VariedPaint, AMixtureFlowsByTheMeanOfItsLogarithmsAndYieldStresses) {
    Bench bench(slope());
    bench.fill([](int, int) { return 1.0; });
    // The sums of what half a millimetre of each carries.
    set_rheology(
        bench, [](int, int) { return std::exp(0.5 * std::log(30.0) + 0.5 * std::log(900.0)); },
        [](int, int) { return 0.5 * 0.6 * kForce; });
    bench.run(0.01, 2.0);
    const double exact = film_velocity(std::sqrt(30.0 * 900.0), 0.3 * kForce);
    EXPECT_NEAR(bench.v(7, 4), exact, 1e-3 * exact);
}

TEST(VariedPaint, ThinnerSetsStandingOilInMotion) {
    Bench bench(slope());
    bench.fill([](int, int) { return 1.0; });
    set_rheology(
        bench, [](int, int) { return 900.0; }, [](int, int) { return 1.2 * kForce; });
    bench.run(0.01, 0.1);
    EXPECT_EQ(bench.v(7, 4), 0.0);
    for (int y = 0; y < bench.setup.height; ++y)
        for (int x = 0; x < bench.setup.width; ++x)
            bench.state.thickness.set(x, y, 3 * bench.state.thickness.at(x, y) / 2);
    bench.run(0.01, 2.0);
    // 1.5 mm of nu = 900^(2/3), tau = 0.8 kForce.
    const double plug = 0.8 / 1.5;
    const double exact = kForce * 1.5 * 1.5 / (3.0 * std::pow(900.0, 2.0 / 3.0)) * (1.0 - plug) *
                         (1.0 - plug) * (1.0 + 0.5 * plug);
    EXPECT_NEAR(bench.v(7, 4), exact, 1e-3 * exact);
}

Scene oily_drop() {
    return {.width = 70,
            .height = 70,
            .gravity = 400,
            .force_y = 120,
            .viscosity = 40,
            .tension = 500,
            .yield = 60,
            .alpha_min = 0.8,
            .alpha_max = 1.2,
            .tan_advancing = 0.5,
            .tan_receding = 0.2,
            .slip_cells = 0.2};
}

double drop_height(int x, int y) {
    const double r = std::hypot(x - 34.5, y - 30.5) / 16.0;
    return r < 1.0 ? 3.0 * (1.0 - r * r) : 0.0;
}

TEST(VariedPaint, OfOneKindFlowsAsUniformPaint) {
    Bench uniform(oily_drop()), varied(oily_drop());
    uniform.fill(drop_height);
    varied.fill(drop_height);
    set_rheology(
        varied, [](int, int) { return 40.0; }, [](int, int) { return 60.0; });
    uniform.run(0.001, 0.5);
    varied.run(0.001, 0.5);
    const double moved = uniform.largest_difference(drop_height);
    const double largest = uniform.largest_difference([&](int x, int y) { return varied.h(x, y); });
    EXPECT_GT(moved, 0.2);
    // Rounding of what thin edges carry lets the front take a cell a little later: 0.4 % here.
    EXPECT_LT(largest, 0.01 * moved);
}

TEST(VariedPaint, KeepsAllThatItCarriesAndNothingGoesNegative) {
    for (const Edge edge : {Edge::Periodic, Edge::Wall, Edge::Open}) {
        Scene scene = oily_drop();
        scene.edge_x = scene.edge_y = edge;
        scene.sleeping = true;
        Bench bench(scene);
        std::mt19937 random(5);
        std::uniform_real_distribution<double> share(0.0, 1.0);
        bench.fill([&](int x, int y) { return share(random) < 0.8 ? drop_height(x, y + 25) : 0.0; });
        for (int k = 0; k < kPaintChannels; ++k)
            bench.tint(k, [&](int, int) { return 5.0 * share(random); });
        set_rheology(
            bench, [&](int, int) { return std::exp(9.0 * share(random)); },
            [&](int, int) { return 200.0 * share(random); });
        const Totals before = totals(bench.state);
        AdvanceReport report;
        for (int i = 0; i < 30; ++i)
            report.add(bench.solver->advance(0.02));
        const Totals after = totals(bench.state);
        EXPECT_EQ(after.thickness + bench.solver->runoff().thickness, before.thickness);
        for (int k = 0; k < kPaintChannels; ++k)
            EXPECT_EQ(after.paint[k] + bench.solver->runoff().paint[k], before.paint[k]) << k;
        for (int y = 0; y < 70; ++y)
            for (int x = 0; x < 70; ++x) {
                ASSERT_GE(bench.state.thickness.at(x, y), 0);
                const PaintCell& cell = bench.state.paint.at(x, y);
                ASSERT_GE(*std::min_element(cell.begin(), cell.end()), 0);
                ASSERT_TRUE(std::isfinite(bench.u(x, y) + bench.v(x, y)));
            }
        EXPECT_EQ(report.clamped_faces, 0);
    }
}

TEST(VariedPaint, GivesTheSameBitsOnAnyNumberOfThreads) {
    const auto hash = [](int threads) {
        core::ThreadPool pool(threads);
        FilmState film = patchwork(4);
        film.consistencies = film::Consistencies::several();
        Solver solver(film, find_medium("house paint"), {}, pool);
        solver.set_gravity(tilted_gravity(60.0));
        solver.advance(0.01);
        return state_hash(film);
    };
    EXPECT_EQ(hash(1), hash(2));
    EXPECT_EQ(hash(1), hash(3));
}

TEST(VariedPaint, NearlyDryPaintStandsOnAnUprightCanvas) {
    core::ThreadPool pool(1);
    const auto moved = [&](double dried_share) {
        const Medium& medium = find_medium("house paint");
        FilmState film({40, 40}, 0.25);
        const auto bump = [](int x, int y) { return 0.05 * drop_height(2 * x, 2 * y); };
        lay(film, bump, kRed, medium);
        dry(film, {.speed = 1.0}, dried_share * medium.touch_dry_s * 0.15 / 0.3, pool);
        film.consistencies = film::Consistencies::several();
        const FilmState before = film;
        Solver solver(film, medium, {}, pool);
        solver.set_gravity(tilted_gravity(90.0));
        solver.advance(0.3);
        float largest = 0.0F;
        for (int y = 0; y < 40; ++y)
            for (int x = 0; x < 40; ++x)
                largest = std::max(largest, std::abs(thickness_mm(film.thickness.at(x, y)) -
                                                     thickness_mm(before.thickness.at(x, y))));
        return largest;
    };
    EXPECT_GT(moved(0.0), 1e-3);
    EXPECT_LT(moved(0.95), 1e-5);
}

TEST(CellRheology, ReadsWhatTheMediumBrought) {
    for (const Medium& medium : bundled_media()) {
        const double h = medium.typical_thickness_mm;
        const PaintCell cell = cell_of(paint_coefficients(kBlue, medium), h);
        const std::int32_t thickness = quanta_of(h);
        float viscosity = 0.0F, yield = 0.0F;
        core::kernels<TileKernels>().rheology(&cell, &thickness, 1, 1.0F, &viscosity, &yield);
        // Half a carried quantum over the thickness, in the exponent.
        EXPECT_NEAR(viscosity / (medium.viscosity_m2_s * 1e6), 1.0, kPaintQuantum / h) << medium.name;
        EXPECT_NEAR(yield, medium.yield_stress_Pa, kPaintQuantum / h) << medium.name;
    }
}

TEST(CellRheology, GivesTheSameBitsOnEveryInstructionSetAndAnyCount) {
    const FilmState film = patchwork(9);
    constexpr int kCount = 200;
    const auto of = [&](core::Isa isa, int chunk) {
        std::vector<float> viscosity(kCount), yield(kCount);
        for (int i = 0; i < kCount; i += chunk)
            core::kernels<TileKernels>(isa).rheology(film.paint.read(0) + i, film.thickness.read(0) + i,
                                                     std::min(chunk, kCount - i), 0.8F, &viscosity[i],
                                                     &yield[i]);
        viscosity.insert(viscosity.end(), yield.begin(), yield.end());
        return viscosity;
    };
    const std::vector<float> expected = of(core::Isa::Baseline, kCount);
    for (const core::Isa isa : {core::Isa::Baseline, core::Isa::Avx2, core::Isa::Avx512}) {
        if (isa > core::best_isa()) continue;
        EXPECT_EQ(of(isa, kCount), expected) << core::name_of(isa);
        EXPECT_EQ(of(isa, 1), expected) << core::name_of(isa);
        EXPECT_EQ(of(isa, 7), expected) << core::name_of(isa);
    }
}

}  // namespace
}  // namespace pastoso::film::test
