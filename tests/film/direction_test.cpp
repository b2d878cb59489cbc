// The same law in every direction: paint does not feel how the cells lie.
#include "film/film_bench.hpp"
#include "film/schemes.hpp"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

namespace pastoso::film::test {
namespace {

using std::numbers::pi;

/// A wave that is periodic on a square of `side` cells, with so many crests along x and y.
struct ObliqueWave {
    int side, crests_x, crests_y;

    double phase(double x, double y) const {
        return 2 * pi * (crests_x * (x + 0.5) + crests_y * (y + 0.5)) / side;
    }
    double amplitude(const Bench& bench) const {
        double cosine = 0, sine = 0;
        for (int y = 0; y < side; ++y)
            for (int x = 0; x < side; ++x) {
                cosine += bench.h(x, y) * std::cos(phase(x, y));
                sine += bench.h(x, y) * std::sin(phase(x, y));
            }
        return std::hypot(cosine, sine) * 2 / (side * side);
    }
};

/// Waves of 12 cells at 0, 37, 30 and 45 degrees.
constexpr ObliqueWave kAlongAxis = {60, 5, 0};
constexpr ObliqueWave kOblique[] = {{60, 4, 3}, {97, 7, 4}, {17, 1, 1}};

ObliqueWave resolved(const ObliqueWave& wave, int times) {
    return {wave.side * times, wave.crests_x, wave.crests_y};
}

struct Levelling {
    double gravity, tension, flow_index;
    int times_finer = 1;
};

/// What is left of brush marks of 5 % when the yield stress holds them against gravity and tension.
double kept_marks(const ObliqueWave& coarse, const Levelling& by, const Scheme& scheme) {
    const ObliqueWave wave = resolved(coarse, by.times_finer);
    Bench bench({.width = wave.side,
                 .height = wave.side,
                 .gravity = by.gravity,
                 .viscosity = 10,
                 .tension = by.tension,
                 .yield = 0.3,
                 .flow_index = by.flow_index,
                 .inertia = false,
                 .solver = scheme.options});
    bench.fill([&](int x, int y) { return 1 + 0.05 * std::cos(wave.phase(x, y)); });
    bench.run(scheme.step_in_limits * bench.solver->stable_step_s(1.0), 120.0);
    return wave.amplitude(bench) / 0.05;
}

TEST(InAllDirections, YieldStressKeepsTheSameMarks) {
    const Scheme scheme = all_schemes().front();
    ASSERT_EQ(scheme.name, "Explicit");
    // Gravity alone leaves a ridge whose crest is a corner, which cells round off.
    for (const Levelling& by :
         {Levelling{.gravity = 0, .tension = 100, .flow_index = 1},
          Levelling{.gravity = 14, .tension = 50, .flow_index = 0.6},
          Levelling{.gravity = 54, .tension = 0, .flow_index = 1, .times_finer = 2}}) {
        const double along = kept_marks(kAlongAxis, by, scheme);
        EXPECT_LT(along, 0.8);
        for (const ObliqueWave& wave : kOblique)
            EXPECT_NEAR(kept_marks(wave, by, scheme) / along, 1.0, 0.03)
                << wave.crests_x << " : " << wave.crests_y << ", g = " << by.gravity << ", tension "
                << by.tension << ", n = " << by.flow_index;
    }
}

/// What a yield stress keeps of brush marks of 5 % on 0.4 mm of paint after a second of ticks.
double kept_in_ticks(const ObliqueWave& wave, film::Scheme scheme) {
    constexpr double kThickness_mm = 0.4, kHeight_mm = 0.05 * kThickness_mm;
    Bench bench({.width = wave.side,
                 .height = wave.side,
                 .cell_mm = 0.125,
                 .viscosity = 250,
                 .tension = 25000,
                 .yield = 8000,
                 .solver = {.scheme = scheme}});
    bench.fill([&](int x, int y) { return kThickness_mm + kHeight_mm * std::cos(wave.phase(x, y)); });
    bench.pass(1.0);
    return wave.amplitude(bench) / kHeight_mm;
}

TEST(InAllDirections, LargeStepsKeepTheMarksThatExplicitOnesKeep) {
    const double along = kept_in_ticks(kAlongAxis, film::Scheme::Explicit);
    EXPECT_GT(along, 0.3);
    EXPECT_LT(along, 0.8);
    EXPECT_NEAR(kept_in_ticks(kAlongAxis, film::Scheme::LargeStep) / along, 1.0, 0.03);
    for (const ObliqueWave& wave : kOblique)
        EXPECT_NEAR(kept_in_ticks(wave, film::Scheme::LargeStep) / along, 1.0, 0.03)
            << wave.crests_x << " : " << wave.crests_y;
}

struct Thinning {
    double flow_index, viscosity, yield;
};

/// How far the middle of a drop has run in a third of a second down a canvas tilted towards `angle_deg`,
/// mm.
double path_of_drop(double angle_deg, const Thinning& paint, film::Scheme scheme, double frame_s) {
    constexpr int kSide = 96;
    constexpr double kCell_mm = 0.25, kForce = 8000, kSeconds = 1.0 / 3.0;
    const double down_x = std::cos(angle_deg * pi / 180), down_y = std::sin(angle_deg * pi / 180);
    Bench bench({.width = kSide,
                 .height = kSide,
                 .cell_mm = kCell_mm,
                 .gravity = 5000,
                 .force_x = kForce * down_x,
                 .force_y = kForce * down_y,
                 .viscosity = paint.viscosity,
                 .tension = 2.5e4,
                 .yield = paint.yield,
                 .tan_advancing = 0.5,
                 .tan_receding = 0.2,
                 .slip_cells = 0.2,
                 .flow_index = paint.flow_index,
                 .full_curvature = true,
                 .solver = {.scheme = scheme}});
    bench.fill([](int x, int y) { return blob(x + 0.5, y + 0.5, 40, 40, 20, 1.0); });
    const auto middle = [&] {
        double along = 0, volume = 0;
        for (int y = 0; y < kSide; ++y)
            for (int x = 0; x < kSide; ++x) {
                along += bench.h(x, y) * (x * down_x + y * down_y);
                volume += bench.h(x, y);
            }
        return along / volume * kCell_mm;
    };
    const double start = middle();
    for (int frame = 0; frame < static_cast<int>(std::lround(kSeconds / frame_s)); ++frame)
        bench.solver->advance(frame_s);
    return middle() - start;
}

class ThinnedDrop : public testing::TestWithParam<Thinning> {};

TEST_P(ThinnedDrop, RunsAsFarInLargeSteps) {
    const double exact = path_of_drop(27, GetParam(), film::Scheme::Explicit, 1.0 / 60);
    EXPECT_GT(exact, 0.8);
    EXPECT_NEAR(path_of_drop(27, GetParam(), film::Scheme::LargeStep, 1.0 / 60) / exact, 1.0, 0.02);
}

TEST_P(ThinnedDrop, RunsAsFarInEveryDirection) {
    for (const film::Scheme scheme : {film::Scheme::Explicit, film::Scheme::LargeStep}) {
        const double along = path_of_drop(0, GetParam(), scheme, 1.0 / 60);
        for (const double angle : {27.0, 45.0})
            EXPECT_NEAR(path_of_drop(angle, GetParam(), scheme, 1.0 / 60) / along, 1.0, 0.01)
                << angle << " degrees, scheme " << static_cast<int>(scheme);
    }
}
INSTANTIATE_TEST_SUITE_P(Laws, ThinnedDrop,
                         testing::Values(Thinning{0.6, 500, 0}, Thinning{0.35, 1200, 0},
                                         Thinning{0.6, 600, 1700}, Thinning{0.8, 150, 0}));

}  // namespace
}  // namespace pastoso::film::test
