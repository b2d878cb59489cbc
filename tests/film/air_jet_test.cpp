// Air that blows on wet paint: where it presses, what it presses into the paint, and that it moves paint
// and makes none.
#include "film/air_jet.hpp"

#include "film/film_bench.hpp"
#include "film/schemes.hpp"

#include <cmath>

#include <gtest/gtest.h>

namespace pastoso::film::test {
namespace {

constexpr double kDensity_kg_m3 = 1000.0;
constexpr double kGravity_mm_s2 = 9810.0;

/// Paint 2 mm deep, 64 mm square, within walls.
Scene basin() {
    Scene scene;
    scene.width = scene.height = 64;
    scene.gravity = kGravity_mm_s2;
    scene.viscosity = 100.0;
    scene.edge_x = scene.edge_y = Edge::Wall;
    return scene;
}

/// Presses a dimple of `depth_mm` into paint of the density above.
AirJet jet_of_depth(double depth_mm) {
    const double pressure_Pa = kDensity_kg_m3 * 9.81 * depth_mm * 1e-3;
    return {.x_mm = 32.0, .y_mm = 32.0, .radius_mm = 8.0, .pressure_Pa = pressure_Pa};
}

TEST(AirPressure, FallsFromTheMiddleOutwards) {
    const AirJet jet{.x_mm = 10.0, .y_mm = 20.0, .radius_mm = 4.0, .pressure_Pa = 50.0};
    EXPECT_DOUBLE_EQ(air_pressure_Pa(jet, 10.0, 20.0), 50.0);
    EXPECT_NEAR(air_pressure_Pa(jet, 14.0, 20.0), 50.0 * std::exp(-1.0), 1e-9);
    EXPECT_NEAR(air_pressure_Pa(jet, 10.0, 12.0), 50.0 * std::exp(-4.0), 1e-9);
    EXPECT_EQ(air_pressure_Pa(jet, 22.1, 20.0), 0.0);
}

TEST(AirPressure, LeaningItPressesMoreAtItsHeel) {
    const AirJet jet{.radius_mm = 4.0, .pressure_Pa = 50.0, .lean_x = 0.5};
    EXPECT_NEAR(air_pressure_Pa(jet, -2.0, 0.0), 50.0 * std::exp(-0.25), 1e-9);
    EXPECT_NEAR(air_pressure_Pa(jet, 2.0, 0.0), 0.0, 1e-9);
    EXPECT_LT(air_pressure_Pa(jet, 4.0, 0.0), 0.0);
}

TEST(AirPressure, ReachesThreeRadii) {
    const AirJet jet{.x_mm = 10.0, .y_mm = 10.0, .radius_mm = 2.0, .pressure_Pa = 1.0};
    const grid::Rect cells = cells_reached(jet, {30, 60}, 0.5);
    EXPECT_EQ(cells.x0, 8);
    EXPECT_EQ(cells.y0, 8);
    EXPECT_EQ(cells.x1, 30);
    EXPECT_EQ(cells.y1, 33);
}

/// The push that steps are planned by is the slope of the pressure, by central differences.
TEST(AirPressure, ThePushIsItsSlope) {
    constexpr double kDelta_mm = 1e-3;
    for (const double lean : {0.0, 0.4, 1.0}) {
        const AirJet jet{
            .radius_mm = 5.0, .pressure_Pa = 30.0, .lean_x = 0.6 * lean, .lean_y = 0.8 * lean};
        for (double x = -14.0; x < 14.0; x += 3.5) {
            const double y = 0.3 * x + 1.0;
            const auto slope_Pa_mm = [&](double dx, double dy) {
                return (air_pressure_Pa(jet, x + dx, y + dy) - air_pressure_Pa(jet, x - dx, y - dy)) /
                       (2.0 * kDelta_mm);
            };
            const double expected =
                std::hypot(slope_Pa_mm(kDelta_mm, 0.0), slope_Pa_mm(0.0, kDelta_mm)) / kDensity_kg_m3 *
                kPaPerDensity_mm2_s2;
            // Central differences err by delta^2 / 6 of the third derivative, 1e-8 of the slope's scale.
            EXPECT_NEAR(air_push_mm_s2(jet, kDensity_kg_m3, x, y), expected, 1e-3) << lean << ' ' << x;
        }
    }
}

/// As a painting lets time pass: an implicit step of many seconds would damp waves by one e alone.
void pass_time(Bench& bench, double seconds) {
    for (int tick = 0; tick < std::lround(60.0 * seconds); ++tick)
        bench.solver->advance(1.0 / 60.0);
}

class AnyScheme : public testing::TestWithParam<Scheme> {};

/// At rest, rho g eta + p is the same everywhere.
TEST_P(AnyScheme, AJetHoldsAHydrostaticDimple) {
    Scene scene = basin();
    scene.solver = GetParam().options;
    Bench bench(scene);
    bench.fill([](int, int) { return 2.0; });
    const Totals before = totals(bench.state);
    const AirJet jet = jet_of_depth(0.3);
    bench.solver->set_air({jet});
    pass_time(bench, 12.0);
    EXPECT_EQ(totals(bench.state).thickness, before.thickness);
    const auto level_mm = [&](int x, int y) {
        return bench.h(x, y) + 0.3 * air_pressure_Pa(jet, x + 0.5, y + 0.5) / jet.pressure_Pa;
    };
    // After twelve seconds, eight times as long as the slowest wave of the basin lasts, what is left of
    // it is e^-8 of a third of a millimetre.
    for (int y = 0; y < 64; ++y)
        for (int x = 0; x < 64; ++x)
            ASSERT_NEAR(level_mm(x, y), level_mm(0, 0), 2e-4) << x << ' ' << y;
    EXPECT_LT(bench.h(32, 32), 1.75);
}

/// When the air is still again the paint levels.
TEST_P(AnyScheme, StillAirLetsTheDimpleClose) {
    Scene scene = basin();
    scene.solver = GetParam().options;
    Bench bench(scene);
    bench.fill([](int, int) { return 2.0; });
    bench.solver->set_air({jet_of_depth(0.3)});
    pass_time(bench, 1.0);
    ASSERT_LT(bench.h(32, 32), 1.8);
    bench.solver->set_air({});
    pass_time(bench, 12.0);
    EXPECT_NEAR(bench.h(32, 32), 2.0, 2e-4);
}

/// A drop below a jet that leans to the right runs to the right, and stays below its toe.
TEST_P(AnyScheme, ALeaningJetCarriesADropWhereItPoints) {
    Scene scene = basin();
    scene.solver = GetParam().options;
    Bench bench(scene);
    bench.fill([](int x, int y) { return blob(x, y, 31.5, 31.5, 6, 2.0); });
    AirJet jet = jet_of_depth(2.0);
    jet.lean_x = 0.8;
    bench.solver->set_air({jet});
    pass_time(bench, 2.0);
    double sum = 0.0, moment = 0.0;
    for (int y = 0; y < 64; ++y)
        for (int x = 0; x < 64; ++x) {
            sum += bench.h(x, y);
            moment += (x + 0.5 - jet.x_mm) * bench.h(x, y);
        }
    // The toe's suction is strongest at three quarters of the radius, 6 mm.
    EXPECT_GT(moment / sum, 2.0);
    EXPECT_LT(moment / sum, 8.0);
}
INSTANTIATE_TEST_SUITE_P(Schemes, AnyScheme, testing::ValuesIn(all_schemes()),
                         [](const auto& test) { return test.param.name; });

/// Yield stress holds against a weak jet.
TEST(AirJet, StiffPaintStandsAgainstAWeakJet) {
    Scene scene = basin();
    scene.yield = 5e4;  // 50 Pa
    Bench bench(scene);
    bench.fill([](int, int) { return 2.0; });
    bench.solver->set_air({jet_of_depth(0.3)});
    bench.solver->advance(2.0);
    EXPECT_EQ(bench.h(32, 32), bench.h(0, 0));
}

/// Steps follow how fast the paint moves, not how hard the air could push it.
TEST(AirJet, AStrongJetOnRunnyPaintTakesFewSteps) {
    Bench bench(basin());
    bench.fill([](int x, int y) { return blob(x, y, 31.5, 31.5, 8, 2.0); });
    AirJet jet = jet_of_depth(100.0);
    jet.lean_x = 0.8;
    int steps = 0;
    for (int tick = 0; tick < 30; ++tick) {
        jet.x_mm = 20.0 + 0.8 * tick;
        bench.solver->set_air({jet});
        steps += bench.solver->advance(1.0 / 60.0).steps;
    }
    // By the hardest push, on the thickest paint, 1e5 mm/s2 on 2 mm: 4000 steps.
    EXPECT_LT(steps, 600);
    EXPECT_GT(bench.h(50, 32), 0.01);
}

/// Across the seam of a periodic canvas nothing is lost, and thread counts do not matter.
TEST(AirJet, MovesPaintExactlyOnAnyNumberOfThreads) {
    std::uint64_t hash = 0;
    for (const int threads : {1, 3}) {
        Scene scene = basin();
        scene.width = 100;
        scene.edge_x = scene.edge_y = Edge::Periodic;
        scene.threads = threads;
        Bench bench(scene);
        bench.fill([](int x, int y) { return blob(x, y, 5, 30, 20, 2.0); });
        const Totals before = totals(bench.state);
        AirJet jet = jet_of_depth(2.0);
        jet.x_mm = 2.0;
        jet.lean_y = -0.5;
        bench.solver->set_air({jet});
        bench.solver->advance(0.5);
        EXPECT_EQ(totals(bench.state).thickness, before.thickness);
        if (threads > 1) {
            EXPECT_EQ(state_hash(bench.state), hash);
        }
        hash = state_hash(bench.state);
    }
}

}  // namespace
}  // namespace pastoso::film::test
