// Terms beyond the plain model: shear thinning after Herschel and Bulkley, the paper's horizontal
// surface tension.
#include "core/isa.hpp"
#include "core/lane_power.hpp"
#include "film/explicit/tile_step.hpp"
#include "film/face/face_physics.hpp"
#include "film/face/shear_thinning.hpp"
#include "film/film_bench.hpp"
#include "film/validation/laws.hpp"

#include <cmath>
#include <memory>
#include <numbers>
#include <ostream>
#include <random>

#include <gtest/gtest.h>

namespace pastoso::film::test {
namespace {

TEST(LanePower, MatchesTheLogarithmAndThePower) {
    std::mt19937 random(1);
    std::uniform_real_distribution<double> uniform(-100.0, 100.0);
    for (int i = 0; i < 20000; ++i) {
        const double y = uniform(random);
        const auto x = static_cast<float>(std::exp2(y));
        const double exact = std::log2(static_cast<double>(x));
        ASSERT_NEAR(lanes::log2(x), exact, 2e-7 * std::max(1.0, std::abs(exact))) << x;
        const auto power = static_cast<float>(y);
        ASSERT_NEAR(lanes::exp2(power) / std::exp2(static_cast<double>(power)), 1.0, 5e-7) << power;
    }
    EXPECT_EQ(lanes::log2(1.0F), 0.0F);
    EXPECT_EQ(lanes::exp2(0.0F), 1.0F);
}

struct FilmLaw {
    double index, yield;
};
void PrintTo(const FilmLaw& law, std::ostream* out) {
    *out << "n = " << law.index << ", tau_y = " << law.yield;
}

constexpr double kConsistency = 0.8, kThickness_mm = 1.3, kForce = 2.0;

double exact_speed(const FilmLaw& law) {
    return validation::plastic_speed(
        {.consistency = kConsistency, .yield = law.yield, .flow_index = law.index}, kForce,
        kThickness_mm);
}

Scene slope(const FilmLaw& law) {
    return {.width = 8,
            .height = 8,
            .cell_mm = 8,  // far from the speed clamp, half a cell a step
            .force_x = kForce,
            .viscosity = kConsistency,
            .yield = law.yield,
            .flow_index = law.index};
}

class SteadyFilm : public testing::TestWithParam<FilmLaw> {};

TEST_P(SteadyFilm, FollowsItsLaw) {
    Bench bench(slope(GetParam()));
    bench.fill([](int, int) { return kThickness_mm; });
    bench.run(0.1, 120.0);  // at n = 0.4 the last per cents decay at 0.15 per second
    EXPECT_NEAR(bench.u(3, 4) / exact_speed(GetParam()), 1.0, 1e-4);  // reached 8e-6
}
INSTANTIATE_TEST_SUITE_P(PowerLaw, SteadyFilm,
                         testing::Values(FilmLaw{0.4, 0}, FilmLaw{0.7, 0}, FilmLaw{1.0, 0}));
INSTANTIATE_TEST_SUITE_P(WithYield, SteadyFilm,
                         testing::Values(FilmLaw{0.3, 1.3}, FilmLaw{0.4, 0.4}, FilmLaw{0.4, 2.0},
                                         FilmLaw{0.7, 0.4}, FilmLaw{0.7, 2.0}, FilmLaw{0.7, 2.5},
                                         FilmLaw{1.0, 2.0}));

/// A millimetre of paint with a wave in it on a tilted canvas, which the force beyond its yield stress
/// carries a fraction of a cell a frame, and all of the force would carry a whole cell.
class LargeStepsNearYield : public testing::TestWithParam<double> {};

TEST_P(LargeStepsNearYield, RunAtBinghamsSpeedAndStaySmooth) {
    constexpr double kTilted = 8490.0, kViscosity = 500.0, kMean_mm = 1.0;
    const double wall = GetParam();  // stress there in yield stresses, x
    Scene scene{.width = 64,
                .height = 64,
                .cell_mm = 0.1,
                .gravity = 4900,
                .force_x = kTilted,
                .viscosity = kViscosity,
                .tension = 2.5e4,
                .yield = kTilted * kMean_mm / wall};
    scene.solver.scheme = film::Scheme::LargeStep;
    Bench bench(scene);
    bench.fill([](int x, int) { return kMean_mm + 0.02 * std::cos(x * std::numbers::pi / 32); });
    for (int frame = 0; frame < 30; ++frame)
        bench.solver->advance(1.0 / 60.0);
    const double newtonian = kTilted * kMean_mm * kMean_mm / (3.0 * kViscosity);
    const double speed = newtonian * (1 - 1 / wall) * (1 - 1 / wall) * (1 + 0.5 / wall);
    double mean = 0.0, across = 0.0;
    for (int y = 0; y < 64; ++y)
        for (int x = 0; x < 64; ++x) {
            mean += bench.u(x, y) / (64 * 64);
            across = std::max(across, std::abs(bench.h(x, y) - bench.h(x, (y + 1) % 64)));
        }
    // The wave that is left changes the mean by its square.
    EXPECT_NEAR(mean / speed, 1.0, 0.01);
    // Nothing varies across the flow but by what the equations of a step may keep of their error, a
    // hundredth of two cells, for as long as the yield stress holds it.
    EXPECT_LT(across, 2 * 0.002);
}
INSTANTIATE_TEST_SUITE_P(WallStresses, LargeStepsNearYield, testing::Values(1.2, 1.5, 3.0));

TEST(ShearThinning, NothingMovesBelowYield) {
    Bench bench(slope({.index = 0.5, .yield = 1.01 * kForce * kThickness_mm}));
    bench.fill([](int, int) { return kThickness_mm; });
    bench.run(0.05, 5.0);
    EXPECT_EQ(bench.u(3, 4), 0.0);
}

// Long steps and short ones, from rest: the lagged viscosity must not swing.
TEST(ShearThinning, AnyStepLengthReachesTheSameSpeed) {
    const FilmLaw law{0.4, 0.4};
    for (const double dt : {0.01, 0.1, 0.25}) {
        Bench bench(slope(law));
        bench.fill([](int, int) { return kThickness_mm; });
        bench.run(dt, 100.0);
        EXPECT_NEAR(bench.u(3, 4) / exact_speed(law), 1.0, 1e-4) << dt;
    }
}

Scene drip(double flow_index, double horizontal_tension) {
    return {.width = 96,
            .height = 64,
            .gravity = 1,
            .force_x = 0.5,
            .force_y = 0.1,
            .tension = 3,
            .yield = 0.05,
            .alpha_min = 0.5,
            .alpha_max = 1.2,
            .tan_advancing = 0.5,
            .tan_receding = 0.2,
            .slip_cells = 0.2,
            .horizontal_tension = horizontal_tension,
            .flow_index = flow_index};
}

double cap(int x, int y) {
    const double r = std::hypot(x - 30, y - 30) / 16;
    return r < 1 ? 4 * (1 - r * r) : 0.0;
}

// The automatic step must hold both terms: nothing clamped, nothing lost, the same bits on two threads.
TEST(RareTerms, KeepTheLawsOfThePlainModel) {
    std::uint64_t hash = 0;
    for (const int threads : {1, 2}) {
        Scene scene = drip(0.5, 1.0);
        scene.threads = threads;
        Bench bench(scene);
        bench.fill(cap);
        const std::int64_t before = totals(bench.state).thickness;
        AdvanceReport report;
        for (int tick = 0; tick < 100; ++tick)
            report.add(bench.solver->advance(0.1));
        EXPECT_EQ(totals(bench.state).thickness, before);
        EXPECT_EQ(report.clamped_faces, 0);
        EXPECT_LT(bench.max_h(), 4.0);
        if (threads == 1) hash = state_hash(bench.state);
        EXPECT_EQ(state_hash(bench.state), hash);
    }
}

// Both terms all but switched off are the plain model. Without the alpha range, which magnifies any
// difference.
TEST(RareTerms, NeutralValuesChangeLittle) {
    const auto run = [](double flow_index, double tension) {
        Scene scene = drip(flow_index, tension);
        scene.alpha_min = scene.alpha_max = 1.0;
        Bench bench(scene);
        bench.fill(cap);
        bench.run(0.04, 10.0);
        return bench.state;
    };
    const FilmState plain = run(1.0, 0.0);
    const FilmState nearly = run(0.9999, 0.0), tense = run(1.0, 1e-6);
    double thinning_difference = 0, tension_difference = 0, volume = 0;
    for (int y = 0; y < 64; ++y)
        for (int x = 0; x < 96; ++x) {
            const double h = thickness_mm(plain.thickness.at(x, y));
            volume += h;
            thinning_difference += std::abs(thickness_mm(nearly.thickness.at(x, y)) - h);
            tension_difference += std::abs(thickness_mm(tense.thickness.at(x, y)) - h);
        }
    EXPECT_LT(thinning_difference / volume, 1e-4);
    EXPECT_LT(tension_difference / volume, 1e-4);
    EXPECT_NE(state_hash(run(1.0, 1.0)), state_hash(plain));
}

StepConstants rough_constants(float yield) {
    StepConstants step;
    step.cell_mm = 0.25F;
    step.inverse_cell = 4.0F;
    step.dt_s = 2e-4F;
    step.gravity_mm_s2 = 5000.0F;
    step.force_y_mm_s2 = 8000.0F;
    step.tension = 2.3e4F;
    step.horizontal_tension = 1.1e4F;
    step.viscosity_mm2_s = 3000.0F;
    step.flow_index = 0.45F;
    step.yield = yield;
    step.tan_advancing = 0.5F;
    step.tan_receding = 0.2F;
    step.wet_mm = 2.5e-5F;
    return step;
}

void fill_randomly(HaloBlock& block) {
    std::mt19937 random(5);
    std::uniform_real_distribution<float> uniform(0.0F, 1.0F);
    for (int i = 0; i < kBlockCells; ++i) {
        const float thickness = uniform(random) < 0.3F ? 0.0F : uniform(random) * 0.8F;
        block.quanta[i] =
            static_cast<std::int32_t>(thickness / static_cast<float>(kThicknessQuantum_mm));
        block.thickness[i] = block.eta[i] = thickness_mm(block.quanta[i]);
        block.support[i] = 0.0F;
        block.velocity_x[i] = uniform(random) - 0.5F;
        block.velocity_y[i] = uniform(random) - 0.5F;
    }
    block.first_wet_row = -kHalo;
    block.last_wet_row = grid::kTileSize + kHalo - 1;
}

TEST(RareTerms, GiveTheSameBitsOnEveryInstructionSet) {
    for (const float yield : {0.0F, 400.0F}) {
        const auto reference = std::make_unique<TileScratch>(),
                   scratch = std::make_unique<TileScratch>();
        fill_randomly(reference->block);
        fill_randomly(scratch->block);
        const StepConstants step = rough_constants(yield);
        core::kernels<TileKernels>(core::Isa::Baseline)
            .flow(step, grid::kTileSize, grid::kTileSize, {}, *reference);
        for (const core::Isa isa : {core::Isa::Avx2, core::Isa::Avx512}) {
            if (isa > core::best_isa()) continue;
            core::kernels<TileKernels>(isa).flow(step, grid::kTileSize, grid::kTileSize, {}, *scratch);
            EXPECT_EQ(scratch->velocity_x, reference->velocity_x) << core::name_of(isa);
            EXPECT_EQ(scratch->flux_y, reference->flux_y) << core::name_of(isa);
        }
    }
}

// chi (sigma/rho) kappa d(eta)/dx / h, with h no thinner than what the contact angle pins.
TEST(HorizontalTension, IsForceOverThickness) {
    StepConstants step;
    step.cell_mm = 0.5F;
    step.inverse_cell = 2.0F;
    step.horizontal_tension = 3.0F;
    step.tan_advancing = 0.8F;
    FaceNeighbourhood<float> face{};
    face.curvature = 0.7F;
    face.eta_left = 1.0F;
    face.eta_right = 1.25F;
    face.h_left = 1.0F;
    face.h_right = 3.0F;
    EXPECT_FLOAT_EQ(horizontal_tension(face, step), 3.0F * 0.7F * 0.5F / 2.0F);
    face.h_left = face.h_right = 0.01F;
    EXPECT_FLOAT_EQ(horizontal_tension(face, step), 3.0F * 0.7F * 0.5F / (0.2F + step.wet_mm));
}

// On a ridge kappa is positive and the force points up the slope: it holds the paint together.
TEST(HorizontalTension, HoldsARidgeTogether) {
    const auto spread = [](double weight) {
        Bench bench(
            {.width = 96, .height = 8, .gravity = 0.5, .tension = 4, .horizontal_tension = weight});
        bench.fill([](int x, int) { return 0.5 + 3 * std::exp(-std::pow((x + 0.5 - 48) / 10, 2)); });
        bench.run(0.02, 4.0);
        return bench.max_h();
    };
    EXPECT_GT(spread(1.0), spread(0.5));
    EXPECT_GT(spread(0.5), spread(0.0));
}

}  // namespace
}  // namespace pastoso::film::test
