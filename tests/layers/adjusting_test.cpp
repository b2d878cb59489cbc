// Dry paint under a glaze and with other pigments: what comes and goes to the quantum, and what is seen.
#include "layers/adjusting.hpp"

#include "film/support/support.hpp"
#include "layers/dry_cells.hpp"
#include "layers/random_layer.hpp"
#include "layers/sums.hpp"

#include <cmath>

#include <gtest/gtest.h>

namespace pastoso::layers {
namespace {

using film::FilmState;
using film::test::kBlue;
using film::test::kRed;

film::PaintCoefficients acrylic(const pigment::Coefficients& pigment) {
    return film::paint_coefficients(pigment, film::find_medium("soft-body acrylic"));
}

/// What a cell carries of a coat that is so thick when it is dry.
film::PaintCell dried_cell(const film::PaintCoefficients& paint, double dry_mm) {
    return film::test::cell_of(paint, dry_mm / paint[film::kSolidsChannel]);
}

class Adjusting : public testing::Test {
  protected:
    void lay_dry(double thickness_mm, const pigment::Coefficients& pigment,
                 const char* medium = "soft-body acrylic") {
        film::test::lay(layer, 3, 4, thickness_mm, pigment, film::find_medium(medium));
        film::dry_now(layer, pool);
    }
    FilmState after(const Adjustment& adjustment, const pigment::Coefficients& pigment = kRed,
                    const grid::Mask* where = nullptr) {
        return adjusted(layer, acrylic(pigment), adjustment, where, pool).film;
    }
    static film::StrataOptics optics(const FilmState& film) { return film.strata.optics.at(3, 4); }

    core::ThreadPool pool{2};
    FilmState layer = test::bare_layer();
};

TEST_F(Adjusting, WhatCameAndWentIsCountedToTheQuantum) {
    for (std::uint32_t seed = 1; seed < 4; ++seed) {
        const FilmState before = test::random_layer(seed);
        for (const Adjustment& adjustment :
             {Adjustment(Glaze{0.02}), Adjustment(Glaze{0.002}), Adjustment(PaintExchange{0.37}),
              Adjustment(PaintExchange{1.0})}) {
            const AdjustedLayer found = adjusted(before, acrylic(kRed), adjustment, nullptr, pool);
            film::DriedTotals expected = film::dried_totals(before.strata);
            expected += found.added;
            expected -= found.removed;
            EXPECT_EQ(film::dried_totals(found.film.strata), expected);
            EXPECT_EQ(found.film.strata.evaporated, before.strata.evaporated + found.evaporated);
            EXPECT_GT(found.added.thickness, 0);
            EXPECT_GT(found.evaporated, 0);
            const bool exchanged = std::holds_alternative<PaintExchange>(adjustment);
            EXPECT_EQ(found.removed.thickness, exchanged ? found.added.thickness : 0);
            EXPECT_EQ(test::sums_of(found.film).relief - test::sums_of(before).relief,
                      exchanged ? 0 : found.added.thickness / film::kQuantaPerSupport);
        }
    }
}

TEST_F(Adjusting, WetPaintIsSharedWithTheLayerBefore) {
    const FilmState before = test::random_layer(2);
    for (const Adjustment& adjustment : {Adjustment(Glaze{0.02}), Adjustment(PaintExchange{0.5})}) {
        const FilmState found = adjusted(before, acrylic(kRed), adjustment, nullptr, pool).film;
        for (int tile = 0; tile < before.shape.tile_count(); ++tile) {
            EXPECT_TRUE(found.thickness.shares_tile(before.thickness, tile));
            EXPECT_TRUE(found.paint.shares_tile(before.paint, tile));
            EXPECT_TRUE(found.lower.paint.shares_tile(before.lower.paint, tile));
            EXPECT_TRUE(found.worked.thickness.shares_tile(before.worked.thickness, tile));
        }
    }
}

TEST_F(Adjusting, NothingExchangedChangesNothing) {
    layer = test::random_layer(5);
    EXPECT_EQ(film::state_hash(after(PaintExchange{0.0})), film::state_hash(layer));
    EXPECT_NE(film::state_hash(after(PaintExchange{0.01})), film::state_hash(layer));
}

TEST_F(Adjusting, ABareLayerStaysBare) {
    EXPECT_EQ(film::state_hash(after(Glaze{0.05})), film::state_hash(layer));
    EXPECT_EQ(film::state_hash(after(PaintExchange{1.0})), film::state_hash(layer));
}

TEST_F(Adjusting, AllOfItForTheSamePaintChangesNothingButRounding) {
    lay_dry(0.03, kBlue);
    const AdjustedLayer found = adjusted(layer, acrylic(kBlue), PaintExchange{1.0}, nullptr, pool);
    for (int k = 0; k < 3 * pigment::kBands; ++k)
        // The support rounds the thickness to 1e-6 mm of 0.02, and layer_optics() is exact to 1e-5.
        EXPECT_NEAR(optics(found.film)[k], optics(layer)[k], 5) << k;
    for (int k = 0; k < film::kPigmentChannels; ++k) {
        const auto went = static_cast<double>(found.removed.pigment[k]);
        EXPECT_NEAR(static_cast<double>(found.added.pigment[k]), went, 1e-4 * went + 1.0) << k;
        EXPECT_NEAR(found.film.strata.uppermost.at(3, 4)[k], layer.strata.uppermost.at(3, 4)[k], 1);
    }
}

TEST_F(Adjusting, HalfOfItIsStirredIntoTheOtherHalf) {
    lay_dry(0.01, kBlue);
    const FilmState half = after(PaintExchange{0.5});
    pigment::Coefficients both{};
    for (std::size_t k = 0; k < both.size(); ++k)
        both[k] = 0.5F * (kBlue[k] + kRed[k]);
    const film::StrataOptics expected =
        film::laid_over(dried_cell(acrylic(both), layer.support_mm.at(3, 4)).data(), film::kClearStrata);
    EXPECT_NE(expected, optics(layer));
    for (int k = 0; k < 3 * pigment::kBands; ++k)
        // The layer before is known to a code of 65535.
        EXPECT_NEAR(optics(half)[k], expected[k], 30) << k;
    EXPECT_EQ(half.support_mm.at(3, 4), layer.support_mm.at(3, 4));
    const pigment::Coefficients before = film::coefficients_of(layer.strata.uppermost.at(3, 4));
    const pigment::Coefficients after_it = film::coefficients_of(half.strata.uppermost.at(3, 4));
    for (int k = 0; k < film::kPigmentChannels; ++k) {
        const float mean = 0.5F * (before[k] + acrylic(kRed)[k]);
        EXPECT_NEAR(after_it[k], mean, 0.01F * mean + 0.01F) << k;
    }
}

TEST_F(Adjusting, AllOfItIsTheNewPaintAsThick) {
    lay_dry(0.03, kBlue);
    const double dry_mm = layer.support_mm.at(3, 4);
    const film::StrataOptics expected =
        film::laid_over(dried_cell(acrylic(kRed), dry_mm).data(), film::kClearStrata);
    for (int k = 0; k < 3 * pigment::kBands; ++k)
        // Pigment is counted in whole quanta there.
        EXPECT_NEAR(optics(after(PaintExchange{1.0}))[k], expected[k], 3) << k;
}

TEST_F(Adjusting, WhatCanBeDissolvedIsExchangedByVolume) {
    lay_dry(0.05, kBlue, "ink glaze");
    ASSERT_GT(layer.strata.soluble_thickness.at(3, 4), 0);
    const FilmState found = after(PaintExchange{0.25});
    EXPECT_EQ(found.strata.soluble_thickness.at(3, 4), layer.strata.soluble_thickness.at(3, 4));
    EXPECT_EQ(optics(found), film::kClearStrata);
    const std::int64_t came = std::llround(0.25 * layer.strata.soluble_thickness.at(3, 4));
    const film::PaintCell added =
        dried_cell(acrylic(kRed), static_cast<double>(came) * film::kThicknessQuantum_mm);
    for (int k = 0; k < film::kPigmentChannels; ++k)
        // What goes and what comes are rounded.
        EXPECT_NEAR(found.strata.soluble_pigment.at(3, 4)[k],
                    0.75 * layer.strata.soluble_pigment.at(3, 4)[k] + added[k], 1.0);
}

TEST_F(Adjusting, AGlazeLiesOverWhatIsDry) {
    lay_dry(0.1, kBlue);
    // 2^-6 mm is a whole number of the quanta of solids.
    const FilmState once = after(Glaze{0x1p-6});
    EXPECT_EQ(once.support_mm.at(3, 4) - layer.support_mm.at(3, 4), 0x1p-6F);
    EXPECT_EQ(optics(once), film::laid_over(dried_cell(acrylic(kRed), 0x1p-6).data(), optics(layer)));
    EXPECT_EQ(once.support_mm.at(4, 4), 0.0F) << "none on bare canvas";
    layer = once;
    EXPECT_EQ(after(Glaze{0x1p-6}).support_mm.at(3, 4) - once.support_mm.at(3, 4), 0x1p-6F);
}

TEST_F(Adjusting, ASoftlyChosenCellGetsItsShare) {
    lay_dry(0.1, kBlue);
    grid::Mask fifth(layer.shape);
    fifth.set(3, 4, grid::kWhole / 5);
    const auto relief_mm = [](const FilmState& film) { return film.support_mm.at(3, 4); };
    EXPECT_NEAR(relief_mm(after(Glaze{0.05}, kRed, &fifth)) - relief_mm(layer), 0.01, 1e-4);
    EXPECT_EQ(film::state_hash(after(PaintExchange{0.5}, kRed, &fifth)),
              film::state_hash(after(PaintExchange{0.5 * (grid::kWhole / 5) / grid::kWhole})));
}

TEST_F(Adjusting, AGlazeTooThinToBindCanBeDissolved) {
    lay_dry(0.1, kBlue);
    const FilmState once = after(Glaze{0x1p-9});
    EXPECT_EQ(optics(once), optics(layer));
    EXPECT_EQ(once.strata.soluble_thickness.at(3, 4), 1 << 16);
    EXPECT_EQ(once.support_mm.at(3, 4) - layer.support_mm.at(3, 4), 0x1p-9F);
}

TEST_F(Adjusting, OnlyWhatTheMaskChoosesIsAdjusted) {
    lay_dry(0.1, kBlue);
    grid::Mask beside(test::kShape);
    beside.set(4, 4, grid::kWhole);
    EXPECT_EQ(film::state_hash(after(Glaze{0.02}, kRed, &beside)), film::state_hash(layer));
    beside.set(3, 4, grid::kWhole);
    EXPECT_NE(optics(after(Glaze{0.02}, kRed, &beside)), optics(layer));
}

TEST_F(Adjusting, AnyNumberOfThreadsGivesTheSame) {
    core::ThreadPool alone(1), three(3);
    const FilmState before = test::random_layer(8);
    for (const Adjustment& adjustment : {Adjustment(Glaze{0.02}), Adjustment(PaintExchange{0.6})})
        EXPECT_EQ(film::state_hash(adjusted(before, acrylic(kRed), adjustment, nullptr, alone).film),
                  film::state_hash(adjusted(before, acrylic(kRed), adjustment, nullptr, three).film));
}

TEST_F(Adjusting, ASampleHasAllCellsOfAFewAndAnEvenPartOfMany) {
    EXPECT_EQ(dry_sample(layer, nullptr).count, 0);
    EXPECT_FALSE(any_dry_cell(layer));
    lay_dry(0.1, kBlue);
    EXPECT_TRUE(any_dry_cell(layer));
    const DrySample one = dry_sample(layer, nullptr);
    ASSERT_EQ(one.count, 1);
    EXPECT_EQ(one.film.support_mm.at(0, 0), layer.support_mm.at(3, 4));
    EXPECT_EQ(one.film.strata.optics.at(0, 0), optics(layer));
    for (int y = 0; y < 70; ++y)
        for (int x = 0; x < 150; ++x)
            film::test::lay(layer, x, y, 0.1, kRed, film::find_medium("soft-body acrylic"));
    film::dry_now(layer, pool);
    EXPECT_EQ(dry_cell_count(layer, nullptr), 10500);
    EXPECT_EQ(dry_sample(layer, nullptr).count, 3500) << "every third one";
    grid::Mask some(test::kShape);
    some.set(100, 50, grid::kWhole);
    EXPECT_EQ(dry_sample(layer, &some).count, 1);
}

}  // namespace
}  // namespace pastoso::layers
