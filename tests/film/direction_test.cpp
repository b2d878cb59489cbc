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

class InAllDirections : public testing::TestWithParam<Scheme> {};

TEST_P(InAllDirections, YieldStressKeepsTheSameMarks) {
    // Gravity alone leaves a ridge whose crest is a corner, which cells round off.
    for (const Levelling& by :
         {Levelling{.gravity = 0, .tension = 100, .flow_index = 1},
          Levelling{.gravity = 14, .tension = 50, .flow_index = 0.6},
          Levelling{.gravity = 54, .tension = 0, .flow_index = 1, .times_finer = 2}}) {
        const double along = kept_marks(kAlongAxis, by, GetParam());
        EXPECT_LT(along, 0.8);
        for (const ObliqueWave& wave : kOblique)
            EXPECT_NEAR(kept_marks(wave, by, GetParam()) / along, 1.0, 0.03)
                << wave.crests_x << " : " << wave.crests_y << ", g = " << by.gravity << ", tension "
                << by.tension << ", n = " << by.flow_index;
    }
}

INSTANTIATE_TEST_SUITE_P(Schemes, InAllDirections, testing::ValuesIn(all_schemes()),
                         [](const auto& scheme) { return scheme.param.name; });

}  // namespace
}  // namespace pastoso::film::test
