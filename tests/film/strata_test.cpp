// Wet paint in two strata (film/cell/lower_stratum.hpp) under the solver.
#include "film/film_bench.hpp"
#include "film/random_paint.hpp"
#include "film/strewn_strata.hpp"

#include <cmath>

#include <gtest/gtest.h>

namespace pastoso::film::test {
namespace {

constexpr int kAbove = 0, kBelow = 7;  ///< channels that only one of the strata carries

bool holds_possible_strata(const FilmState& film) {
    for (int y = 0; y < film.shape.height; ++y)
        for (int x = 0; x < film.shape.width; ++x) {
            const LowerCell lower{film.lower.thickness.at(x, y), film.lower.paint.at(x, y)};
            if (!is_part_of(lower, film.thickness.at(x, y), film.paint.at(x, y))) return false;
        }
    return true;
}

bool has_strata(const FilmState& film) {
    for (int tile = 0; tile < film.shape.tile_count(); ++tile)
        if (film.lower.is_in(tile)) return true;
    return false;
}

Scene drip_scene(film::Scheme scheme, int threads = 1) {
    Scene scene = runny(200, 150);
    scene.threads = threads;
    scene.solver.scheme = scheme;
    return scene;
}

void lay_drips(Bench& bench) {
    bench.fill([](int x, int y) { return blob(x, y, 70, 60, 18, 3.5) + blob(x, y, 20, 50, 9, 1); });
    bench.tint(2, [](int x, int y) { return x + y; });
    bench.tint(5, [](int, int y) { return 900.0 - y; });
}

class StrataOfEveryScheme : public testing::TestWithParam<film::Scheme> {};

/// What happens to the whole does not depend on the order of the paints, nor does any get lost.
TEST_P(StrataOfEveryScheme, LeaveTheWholeAsItIs) {
    Bench one(drip_scene(GetParam())), two(drip_scene(GetParam()));
    lay_drips(one);
    lay_drips(two);
    strew_strata(two.state, 5);
    const Totals before = totals(two.state);
    const double step_s = GetParam() == film::Scheme::Explicit ? 0.04 : 2.0;
    one.run(step_s, 24.0);
    two.run(step_s, 24.0);
    const Totals after = totals(two.state), runoff = two.solver->runoff();
    EXPECT_EQ(after.thickness + runoff.thickness, before.thickness);
    for (int k = 0; k < kPaintChannels; ++k)
        EXPECT_EQ(after.paint[k] + runoff.paint[k], before.paint[k]) << k;
    EXPECT_TRUE(holds_possible_strata(two.state));
    EXPECT_TRUE(has_strata(two.state));
    for (int y = 0; y < 150; ++y)
        for (int x = 0; x < 200; ++x)
            ASSERT_EQ(two.state.thickness.at(x, y), one.state.thickness.at(x, y)) << x << ", " << y;
}

TEST_P(StrataOfEveryScheme, AreTheSameOnAnyNumberOfThreads) {
    const auto hash = [&](int threads) {
        Bench bench(drip_scene(GetParam(), threads));
        lay_drips(bench);
        strew_strata(bench.state, 6);
        bench.run(GetParam() == film::Scheme::Explicit ? 0.04 : 2.0, 8.0);
        return state_hash(bench.state);
    };
    const std::uint64_t reference = hash(1);
    EXPECT_EQ(hash(3), reference);
}

INSTANTIATE_TEST_SUITE_P(Schemes, StrataOfEveryScheme,
                         testing::Values(film::Scheme::Explicit, film::Scheme::LargeStep), [](const auto& test) {
                             return test.param == film::Scheme::Explicit ? "Explicit" : "LargeStep";
                         });

TEST(Strata, SurviveRandomPaintOnEveryKindOfEdge) {
    for (const EdgeKind edges : {EdgeKind::Periodic, EdgeKind::Wall, EdgeKind::Open, EdgeKind::Mixed})
        for (std::uint32_t seed = 1; seed <= 6; ++seed) {
            const RandomPaint paint = random_paint(seed, edges);
            Bench bench(paint.scene);
            bench.fill(paint.thickness);
            bench.set_support(paint.support);
            bench.tint(3, [](int x, int y) { return (x * 7 + y * 3) % 40; });
            strew_strata(bench.state, seed);
            const Totals before = totals(bench.state);
            for (int step = 0; step < 40; ++step)
                bench.solver->advance(0.01);
            const Totals after = totals(bench.state), runoff = bench.solver->runoff();
            EXPECT_EQ(after.paint[3] + runoff.paint[3], before.paint[3]) << name_of(edges) << seed;
            EXPECT_EQ(after.thickness + runoff.thickness, before.thickness);
            ASSERT_TRUE(holds_possible_strata(bench.state)) << name_of(edges) << seed;
        }
}

/// A level sheet 1 mm thick, half of it above, that is pushed along x. Each stratum carries a patch of
/// its own pigment.
struct Sheet {
    Sheet() : bench(scene()) {
        bench.fill([](int, int) { return 1.0; });
        const auto patch = [](int x, int) { return std::abs(x - 32) < 8 ? 40.0 : 0.0; };
        bench.tint(kAbove, patch);
        bench.tint(kBelow, patch);
        for (int y = 0; y < bench.setup.height; ++y)
            for (int x = 0; x < bench.setup.width; ++x) {
                bench.state.lower.thickness.set(x, y, bench.state.thickness.at(x, y) / 2);
                PaintCell paint{};
                paint[kBelow] = bench.state.paint.at(x, y)[kBelow];
                bench.state.lower.paint.set(x, y, paint);
            }
    }
    static Scene scene() {
        Scene scene;
        scene.width = 128;
        scene.height = 4;
        scene.force_x = 3.0;
        scene.viscosity = 1.0;
        return scene;
    }
    double middle(int channel) const {
        double sum = 0.0, moment = 0.0;
        for (int x = 0; x < 128; ++x) {
            sum += bench.state.paint.at(x, 1)[channel];
            moment += x * static_cast<double>(bench.state.paint.at(x, 1)[channel]);
        }
        return moment / sum;
    }
    /// Of the pigment that began above, the share that is below now.
    double sunk() const {
        double below = 0.0, all = 0.0;
        for (int x = 0; x < 128; ++x) {
            below += bench.state.lower.paint.at(x, 1)[kAbove];
            all += bench.state.paint.at(x, 1)[kAbove];
        }
        return below / all;
    }
    Bench bench;
};

/// phi(1/2) = 11/16 of the flux for alpha = 1, so that the strata's mean speeds are 11/8 and 5/8.
TEST(Strata, TheUpperRunsAheadAsTheProfileHasIt) {
    Sheet sheet;
    const double above = sheet.middle(kAbove), below = sheet.middle(kBelow);
    sheet.bench.run(0.02, 2.0);
    const double way_above = sheet.middle(kAbove) - above, way_below = sheet.middle(kBelow) - below;
    EXPECT_GT(way_above + way_below, 1.0);
    EXPECT_NEAR(way_above / way_below, 11.0 / 5.0, 0.06);
}

/// gamma = 3/2 u t / h in the middle of such a film; with m = gamma / (gamma + 40) a step, what has not
/// sunk of a half goes as e^(-gamma / 40).
TEST(Strata, ShearMixesThemAndRestDoesNot) {
    Sheet sheet;
    sheet.bench.run(0.02, 20.0);
    // u = F h2 / 3 nu = 1 mm/s once it runs; the start takes 1 / 2.47 s.
    const double strain = 1.5 * (20.0 - 1.0 / 2.47);
    EXPECT_NEAR(sheet.sunk(), 0.5 * (1.0 - std::exp(-strain / 40.0)), 0.02);

    Scene still = Sheet::scene();
    still.force_x = 0.0;
    Sheet resting;
    Bench level(still);
    level.state = resting.bench.state;
    const std::uint64_t before = state_hash(level.state);
    level.run(0.02, 5.0);
    EXPECT_EQ(state_hash(level.state), before);
}

TEST(Strata, ThatLookAlikeBecomeOneWhenTheirTileRests) {
    FilmState film({70, 10}, 0.25);
    PaintCell paint{};
    paint[1] = paint[8] = 4000;
    film.thickness.set(3, 3, 1 << 22);
    film.paint.set(3, 3, paint);
    PaintCell half = paint;
    half[1] = 2050;
    half[8] = 2000;
    film.lower.thickness.set(3, 3, 1 << 21);
    film.lower.paint.set(3, 3, half);
    EXPECT_TRUE(join_like_strata(film, 0));
    EXPECT_FALSE(film.lower.is_in(0));
    half[1] = 1500;
    film.lower.thickness.set(3, 3, 1 << 21);
    film.lower.paint.set(3, 3, half);
    EXPECT_FALSE(join_like_strata(film, 0));
    EXPECT_TRUE(film.lower.is_in(0));
    film.lower.thickness.set(3, 3, (1 << 14) - 1);
    EXPECT_TRUE(join_like_strata(film, 0));
}

}  // namespace
}  // namespace pastoso::film::test
