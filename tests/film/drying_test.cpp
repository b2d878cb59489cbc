#include "film/cell/drying.hpp"

#include "film/cell/ageing.hpp"
#include "film/cell/dissolving.hpp"
#include "film/dry_film.hpp"

#include <gtest/gtest.h>

namespace pastoso::film::test {
namespace {

constexpr DryingAir kStillAir{.speed = 1.0};

/// Everything that was ever laid, as sums.
DriedTotals all_paint(const FilmState& film) {
    DriedTotals sums = dried_totals(film.strata);
    const Totals wet = totals(film);
    sums.thickness += wet.thickness + film.strata.evaporated;
    for (int k = 0; k < kPigmentChannels; ++k)
        sums.pigment[k] += wet.paint[k];
    return sums;
}

TEST(Drying, BalancesExactlyInEveryChannel) {
    core::ThreadPool pool(1);
    FilmState film = patchwork(3);
    const DriedTotals before = all_paint(film);
    for (int i = 0; i < 12; ++i) {
        dry(film, kStillAir, 45.0 * (i + 1), pool);
        dissolve(film, 1.0, pool);
        EXPECT_EQ(all_paint(film), before) << i;
    }
    EXPECT_GT(dried_totals(film.strata).thickness, 0);
    EXPECT_GT(totals(film).thickness, 0);
    dry_now(film, pool);
    EXPECT_EQ(all_paint(film), before);
    EXPECT_FALSE(has_wet_paint(film));
}

TEST(Drying, OfTwoStrataIsThatOfOneAfterTheOther) {
    core::ThreadPool pool(1);
    const Medium& oil = find_medium("heavy-body oil");
    FilmState in_turn({8, 8}, 0.25), at_once({8, 8}, 0.25);
    lay(in_turn, 3, 3, 0.2, kBlue, oil);
    const LowerCell lower{in_turn.thickness.at(3, 3), in_turn.paint.at(3, 3)};
    dry_now(in_turn, pool);
    lay(in_turn, 3, 3, 0.1, kRed, oil);
    at_once.lower.thickness.set(3, 3, lower.thickness);
    at_once.lower.paint.set(3, 3, lower.paint);
    at_once.thickness.set(3, 3, lower.thickness + in_turn.thickness.at(3, 3));
    PaintCell both = lower.paint;
    for (int k = 0; k < kPaintChannels; ++k)
        both[k] += in_turn.paint.at(3, 3)[k];
    at_once.paint.set(3, 3, both);
    dry_now(in_turn, pool);
    dry_now(at_once, pool);
    EXPECT_EQ(state_hash(at_once), state_hash(in_turn));
}

TEST(Drying, LeavesStrataTheirShares) {
    core::ThreadPool pool(1);
    FilmState film = patchwork(4);
    for (int i = 0; i < 5; ++i) {
        dry(film, kStillAir, 100.0, pool);
        for (int y = 0; y < film.shape.height; ++y)
            for (int x = 0; x < film.shape.width; ++x)
                ASSERT_TRUE(is_part_of({film.lower.thickness.at(x, y), film.lower.paint.at(x, y)},
                                       film.thickness.at(x, y), film.paint.at(x, y)))
                    << x << ", " << y;
    }
}

TEST(Drying, AFilmOfTheTypicalThicknessIsDryInTheTimeOfItsMedium) {
    core::ThreadPool pool(1);
    for (const Medium& medium : bundled_media()) {
        FilmState film({8, 8}, 0.25);
        const auto typical = [&](int, int) { return medium.typical_thickness_mm; };
        lay(film, typical, kRed, medium);
        dry(film, kStillAir, 0.999 * medium.touch_dry_s, pool);
        EXPECT_TRUE(has_wet_paint(film)) << medium.name;
        dry(film, kStillAir, 0.002 * medium.touch_dry_s, pool);
        EXPECT_FALSE(has_wet_paint(film)) << medium.name;
    }
}

TEST(Drying, ThinPaintDriesBeforeThick) {
    core::ThreadPool pool(1);
    const Medium& medium = find_medium("soft-body acrylic");
    FilmState film({60, 4}, 0.25);
    lay(
        film, [](int x, int) { return 0.02 * (x + 1); }, kRed, medium);
    dry(film, kStillAir, 0.5 * medium.touch_dry_s, pool);
    for (int x = 0; x < 60; ++x) {
        // Half the time of 0.5 mm is that of 0.25 mm, between the cells 11 and 12.
        const bool wet = film.thickness.at(x, 2) > 0;
        EXPECT_EQ(wet, x >= 12) << x;
    }
}

TEST(Drying, TheSurfaceDoesNotJumpWhenACellBecomesDry) {
    core::ThreadPool pool(1);
    const Medium& medium = find_medium("fluid acrylic");
    FilmState film({4, 4}, 0.25);
    lay(
        film, [](int, int) { return 0.35; }, kRed, medium);
    double surface = 0.35;
    for (int i = 0; i < 1000 && has_wet_paint(film); ++i) {
        dry(film, kStillAir, medium.touch_dry_s / 500.0, pool);
        const double now = thickness_mm(film.thickness.at(1, 1)) + film.support_mm.at(1, 1);
        EXPECT_LE(now, surface + 1e-6);
        EXPECT_GT(now, surface - 0.5 * 0.35 / 500.0 - 1e-5) << i;
        surface = now;
    }
    EXPECT_NEAR(surface, 0.5 * 0.35, 1e-5);
}

TEST(Drying, AFanDriesWhereItBlows) {
    core::ThreadPool pool(1);
    const Medium& medium = find_medium("house paint");
    FilmState film({200, 8}, 0.25);
    lay(
        film, [](int, int) { return 0.3; }, kRed, medium);
    const DryingAir fan{.speed = 1, .fan = 10, .fan_x_mm = 12.5, .fan_y_mm = 1, .fan_radius_mm = 10};
    dry(film, fan, 0.15 * medium.touch_dry_s, pool);
    EXPECT_EQ(film.thickness.at(50, 4), 0);
    EXPECT_GT(film.thickness.at(150, 4), 0);
    EXPECT_DOUBLE_EQ(fan.rate_at(12.5, 1.0), 10.0);
    EXPECT_DOUBLE_EQ(fan.rate_at(22.5, 1.0), 1.0);
    EXPECT_DOUBLE_EQ((DryingAir{.speed = 1, .fan = 10}.rate_at(99.0, 99.0)), 10.0);
}

TEST(Drying, DoesNotChangeTheColour) {
    core::ThreadPool pool(1);
    FilmState film({8, 8}, 0.25);
    lay(film, 3, 3, 0.1, kBlue, find_medium("heavy-body oil"));
    const pigment::Bands wet = wet_over(film.paint.at(3, 3).data(), kWhiteGround);
    dry_now(film, pool);
    expect_seen(film.strata.optics.at(3, 3), wet);
    EXPECT_EQ(film.strata.optics.at(4, 3), kClearStrata);
}

TEST(Drying, TilesThatAreDryCostNothing) {
    core::ThreadPool pool(1);
    FilmState film({200, 200}, 0.25);
    lay(film, 3, 3, 0.1, kBlue, find_medium("heavy-body oil"));
    dry_now(film, pool);
    EXPECT_EQ(film.thickness.allocated_bytes() + film.paint.allocated_bytes(), 0U);
    EXPECT_EQ(film.strata.soluble_pigment.allocated_bytes(), 0U);
    EXPECT_EQ(film.strata.optics.allocated_bytes(), sizeof(StrataOptics) * grid::kTileCells);
}

TEST(Drying, GivesTheSameBitsOnAnyNumberOfThreads) {
    const auto hash = [](int threads) {
        core::ThreadPool pool(threads);
        FilmState film = patchwork(8);
        for (int i = 0; i < 5; ++i) {
            dry(film, {.speed = 1, .fan = 5, .fan_x_mm = 10, .fan_y_mm = 10, .fan_radius_mm = 15}, 100.0,
                pool);
            dissolve(film, 2.0, pool);
        }
        return state_hash(film);
    };
    EXPECT_EQ(hash(1), hash(2));
    EXPECT_EQ(hash(1), hash(3));
}

TEST(Dissolving, ThinnerLiftsDriedInkAndTheSurfaceStays) {
    core::ThreadPool pool(1);
    FilmState film({8, 8}, 0.25);
    lay(film, 3, 3, 0.08, kBlue, find_medium("ink glaze"));
    const PaintCell ink = film.paint.at(3, 3);
    dry_now(film, pool);
    const auto surface = [&] {
        return film.support_mm.at(3, 3) + thickness_mm(film.thickness.at(3, 3));
    };
    lay(film, 3, 3, 0.1, {}, find_medium("thinner"));
    const double before = surface();
    dissolve(film, kDissolvingTime_s, pool);
    const double lifted = static_cast<double>(film.paint.at(3, 3)[3]) / ink[3];
    EXPECT_NEAR(lifted, 1.0 - std::exp(-1.0), 1e-4);
    EXPECT_NEAR(surface(), before, 1e-7);
    for (int i = 0; i < 20; ++i)
        dissolve(film, kDissolvingTime_s, pool);
    for (int k = 0; k < kPigmentChannels; ++k)
        EXPECT_EQ(film.paint.at(3, 3)[k], ink[k]);
    EXPECT_EQ(film.support_mm.at(3, 3), 0.0F);
    EXPECT_TRUE(film.strata.soluble_pigment.is_background(0));
}

TEST(Dissolving, DriedOilAndAcrylicStay) {
    core::ThreadPool pool(1);
    for (const char* name : {"heavy-body oil", "soft-body acrylic", "fluid acrylic", "house paint"}) {
        FilmState film({8, 8}, 0.25);
        lay(film, 3, 3, 0.1, kBlue, find_medium(name));
        dry_now(film, pool);
        lay(film, 3, 3, 0.1, {}, find_medium("thinner"));
        const std::uint64_t before = state_hash(film);
        dissolve(film, 1000.0, pool);
        EXPECT_EQ(state_hash(film), before) << name;
    }
}

TEST(Dissolving, OilHasNoSolventToDissolveWith) {
    core::ThreadPool pool(1);
    FilmState film({8, 8}, 0.25);
    lay(film, 3, 3, 0.08, kBlue, find_medium("ink glaze"));
    dry_now(film, pool);
    lay(film, 3, 3, 0.5, kRed, find_medium("heavy-body oil"));
    const PigmentCell before = film.strata.soluble_pigment.at(3, 3);
    dissolve(film, 10.0, pool);
    EXPECT_EQ(film.strata.soluble_pigment.at(3, 3), before);
}

TEST(AgeingClock, DriesInIntervalsThatAddUp) {
    core::ThreadPool pool(1);
    const Medium& medium = find_medium("soft-body acrylic");
    FilmState film({8, 8}, 0.25);
    lay(
        film, [](int, int) { return 0.5; }, kRed, medium);
    AgeingClock clock;
    const std::int32_t start = film.paint.at(3, 3)[kDryingChannel];
    const DryingAir air{.speed = 20.0};
    for (int tick = 0; tick < 600; ++tick)
        clock.tick(1.0 / 60.0, air, film, pool);
    const double passed_s = (start - film.paint.at(3, 3)[kDryingChannel]) * kPaintQuantum * 3600.0;
    EXPECT_NEAR(passed_s, 200.0, 11.0);  // one interval may be pending
    const FilmState still = film;
    for (int tick = 0; tick < 600; ++tick)
        clock.tick(1.0 / 60.0, {}, film, pool);
    EXPECT_TRUE(film.paint.shares_tile(still.paint, 0));
}

}  // namespace
}  // namespace pastoso::film::test
