#include "layers/transform.hpp"

#include "layers/footprint.hpp"
#include "layers/random_layer.hpp"
#include "layers/sums.hpp"

#include <map>
#include <numeric>

#include <gtest/gtest.h>

namespace pastoso::layers {
namespace {

using film::FilmState;
using test::sums_of;

/// Rounding of a polygon's area.
constexpr double kRounding = 1e-9;

TEST(FootprintShares, OfAShiftAreThoseOfLinearInterpolation) {
    Footprint footprint({1, 0, 0.25, 0, 1, 0.5});
    std::map<std::pair<int, int>, double> found;
    for (const CellShare& share : footprint.of(4, 7))
        found[{share.x, share.y}] = share.share;
    const std::map<std::pair<int, int>, double> expected = {
        {{4, 7}, 0.375}, {{5, 7}, 0.125}, {{4, 8}, 0.375}, {{5, 8}, 0.125}};
    ASSERT_EQ(found.size(), expected.size());
    for (const auto& [cell, share] : expected)
        EXPECT_NEAR(found[cell], share, kRounding);
}

TEST(FootprintShares, OfAnEnlargementInterpolateAndOfAReductionAverage) {
    Footprint enlarged({0.25, 0, 0, 0, 0.25, 0});
    // The middle of cell 4 comes from 1.125, between the middles of the cells 0 and 1.
    double first = 0.0, second = 0.0;
    for (const CellShare& share : enlarged.of(4, 4))
        (share.x == 0 ? first : second) += share.share;
    EXPECT_NEAR(first, 0.375, kRounding);
    EXPECT_NEAR(second, 0.625, kRounding);
    Footprint reduced({3, 0, 0, 0, 3, 0});
    const auto shares = reduced.of(1, 2);
    ASSERT_EQ(shares.size(), 9U);
    for (const CellShare& share : shares)
        EXPECT_NEAR(share.share, 1.0 / 9.0, kRounding);
}

TEST(FootprintShares, SumToOneAndLieAboutTheMiddle) {
    for (int i = 0; i < 60; ++i) {
        const double angle = 0.1 * i, scale = 0.3 + 0.05 * i;
        const Projective map{scale * std::cos(angle), -scale * std::sin(angle), 3.3 * i,
                             scale * std::sin(angle), scale * std::cos(angle),  -1.7};
        Footprint footprint(map);
        double sum = 0.0, x = 0.0, y = 0.0;
        for (const CellShare& share : footprint.of(i, 2 * i)) {
            sum += share.share;
            x += share.share * (share.x + 0.5);
            y += share.share * (share.y + 0.5);
        }
        EXPECT_NEAR(sum, 1.0, kRounding);
        const grid::Point middle = map(i + 0.5, 2 * i + 0.5);
        // The middle of a cell stands for all parts of it.
        EXPECT_NEAR(x, middle.x, 0.5);
        EXPECT_NEAR(y, middle.y, 0.5);
    }
}

TEST(FootprintShares, AnInverseTakesBack) {
    const Projective map{0.7, -1.2, 5.0, 0.4, 2.2, -8.0};
    const grid::Point there = map(3.0, 4.0);
    const grid::Point back = inverse(map)(there.x, there.y);
    EXPECT_NEAR(back.x, 3.0, kRounding);
    EXPECT_NEAR(back.y, 4.0, kRounding);
}

class Transforming : public testing::Test {
  protected:
    FilmState moved(const FilmState& layer, const Transform& transform) {
        return transformed(layer, in_cells(transform, layer.cell_mm), pool);
    }
    /// A layer whose paint lies well inside the canvas.
    static FilmState inner_layer(std::uint32_t seed) {
        const FilmState all = test::random_layer(seed);
        return cut_to(all, 60, 20, 90, 50);
    }
    static FilmState cut_to(const FilmState& all, int x0, int y0, int x1, int y1) {
        FilmState layer = test::bare_layer();
        layer.consistencies = film::Consistencies::several();
        for (int y = y0; y < y1; ++y)
            for (int x = x0; x < x1; ++x) {
                layer.thickness.set(x, y, all.thickness.at(x, y));
                layer.paint.set(x, y, all.paint.at(x, y));
                layer.support_mm.set(x, y, all.support_mm.at(x, y));
                layer.strata.soluble_thickness.set(x, y, all.strata.soluble_thickness.at(x, y));
                layer.strata.soluble_pigment.set(x, y, all.strata.soluble_pigment.at(x, y));
                layer.strata.optics.set(x, y, all.strata.optics.at(x, y));
                layer.strata.uppermost.set(x, y, all.strata.uppermost.at(x, y));
                layer.strata.fixed.thickness +=
                    std::llround(all.support_mm.at(x, y) / film::kThicknessQuantum_mm) -
                    all.strata.soluble_thickness.at(x, y);
            }
        layer.strata.fixed.pigment.fill(layer.strata.fixed.thickness / 3);
        return layer;
    }
    static bool same_cell(const FilmState& a, int ax, int ay, const FilmState& b, int bx, int by) {
        return a.thickness.at(ax, ay) == b.thickness.at(bx, by) &&
               a.paint.at(ax, ay) == b.paint.at(bx, by) &&
               a.support_mm.at(ax, ay) == b.support_mm.at(bx, by) &&
               a.strata.soluble_thickness.at(ax, ay) == b.strata.soluble_thickness.at(bx, by) &&
               a.strata.soluble_pigment.at(ax, ay) == b.strata.soluble_pigment.at(bx, by) &&
               a.strata.optics.at(ax, ay) == b.strata.optics.at(bx, by);
    }
    static double volume(const FilmState& layer) {
        return static_cast<double>(film::totals(layer).thickness +
                                   film::dried_totals(layer.strata).thickness);
    }

    core::ThreadPool pool{2};
};

TEST_F(Transforming, NothingLeavesEverythingAsItIs) {
    const FilmState layer = test::random_layer(2);
    EXPECT_EQ(film::state_hash(moved(layer, {})), film::state_hash(layer));
}

TEST_F(Transforming, WholeCellsMoveExactlyAndBack) {
    const FilmState layer = inner_layer(2);
    const FilmState there = moved(layer, {.move_x_mm = 7.5, .move_y_mm = -3.25});
    EXPECT_EQ(sums_of(there), sums_of(layer));
    for (int y = 20; y < 50; ++y)
        for (int x = 60; x < 90; ++x)
            ASSERT_TRUE(same_cell(layer, x, y, there, x + 30, y - 13)) << x << ", " << y;
    EXPECT_EQ(film::state_hash(moved(there, {.move_x_mm = -7.5, .move_y_mm = 3.25})),
              film::state_hash(layer));
}

TEST_F(Transforming, QuarterTurnsAndMirrorsAreExact) {
    const FilmState layer = inner_layer(3);
    const Transform turn{.centre_x_mm = 18.75, .centre_y_mm = 8.75, .turn_deg = 90};
    const FilmState turned = moved(layer, turn);
    // Clockwise: what lies right of the centre comes below it.
    for (int y = 20; y < 50; ++y)
        for (int x = 60; x < 90; ++x)
            ASSERT_TRUE(same_cell(layer, x, y, turned, 75 - (y - 35) - 1, 35 + (x - 75)));
    EXPECT_EQ(sums_of(turned), sums_of(layer));
    EXPECT_EQ(film::state_hash(moved(moved(moved(turned, turn), turn), turn)), film::state_hash(layer));
    Transform mirror = turn;
    mirror.turn_deg = 0.0;
    mirror.scale_x = -1.0;
    const FilmState mirrored = moved(layer, mirror);
    for (int y = 20; y < 50; ++y)
        for (int x = 60; x < 90; ++x)
            ASSERT_TRUE(same_cell(layer, x, y, mirrored, 149 - x, y));
}

TEST_F(Transforming, TurningKeepsVolumeAndPigment) {
    for (const double turn_deg : {10.0, 37.0, 45.0, -100.0}) {
        const FilmState layer = inner_layer(4);
        const FilmState turned =
            moved(layer, {.centre_x_mm = 18.75, .centre_y_mm = 8.75, .turn_deg = turn_deg});
        // Half a quantum in each of 2000 cells, against some 10^9 quanta.
        EXPECT_NEAR(volume(turned) / volume(layer), 1.0, 1e-6);
        const auto before = sums_of(layer).pigment, after = sums_of(turned).pigment;
        for (std::size_t k = 0; k < before.size(); ++k) {
            const auto amount = static_cast<double>(before[k]);
            EXPECT_NEAR(static_cast<double>(after[k]), amount, 1e-4 * amount + 2000.0) << k;
        }
    }
}

TEST_F(Transforming, ScalingKeepsThicknessSoVolumeGrowsAsTheArea) {
    const FilmState layer = inner_layer(5);
    for (const double scale : {0.5, 0.8, 1.3}) {
        const FilmState scaled = moved(layer, {.centre_x_mm = 18.75,
                                               .centre_y_mm = 8.75,
                                               .turn_deg = 20,
                                               .scale_x = scale,
                                               .scale_y = 0.9});
        // Cells of an enlargement are samples of an interpolation; the noise of the layer stays in.
        EXPECT_NEAR(volume(scaled) / (scale * 0.9 * volume(layer)), 1.0, 0.01) << scale;
    }
}

TEST_F(Transforming, AnEvenSlabStaysEven) {
    FilmState layer = test::bare_layer();
    for (int y = 10; y < 60; ++y)
        for (int x = 40; x < 110; ++x)
            film::test::lay(layer, x, y, 0.5, film::test::kBlue, film::find_medium("heavy-body oil"));
    const film::PaintCell paint = layer.paint.at(75, 35);
    const std::int32_t thickness = layer.thickness.at(75, 35);
    for (const double scale : {0.7, 1.0, 1.6}) {
        const FilmState turned = moved(layer, {.centre_x_mm = 18.75,
                                               .centre_y_mm = 8.75,
                                               .turn_deg = 31,
                                               .scale_x = scale,
                                               .scale_y = scale});
        for (int y = 27; y < 43; ++y)
            for (int x = 65; x < 85; ++x) {
                ASSERT_EQ(turned.thickness.at(x, y), thickness);
                ASSERT_EQ(turned.paint.at(x, y), paint);
            }
    }
}

TEST_F(Transforming, WhatComesBeyondTheCanvasIsGone) {
    const FilmState layer = inner_layer(6);
    EXPECT_EQ(sums_of(moved(layer, {.move_x_mm = 500.0})), sums_of(test::bare_layer()));
    const FilmState half = moved(layer, {.move_x_mm = (150 - 75) * test::kCell_mm});
    EXPECT_GT(volume(half), 0.3 * volume(layer));
    EXPECT_LT(volume(half), 0.7 * volume(layer));
    EXPECT_EQ(moved(layer, {.move_x_mm = -1e6, .move_y_mm = 1e6}).strata.fixed, film::DriedTotals{});
}

TEST_F(Transforming, IsTheSameOnAnyNumberOfThreads) {
    core::ThreadPool alone(1), three(3);
    const FilmState layer = test::random_layer(7);
    const Transform transform{.centre_x_mm = 10, .turn_deg = 23, .scale_x = 1.2};
    const Projective map = in_cells(transform, layer.cell_mm);
    EXPECT_EQ(film::state_hash(transformed(layer, map, alone)),
              film::state_hash(transformed(layer, map, three)));
}

TEST_F(Transforming, AMaskComesAlong) {
    const grid::Mask mask = grid::polygon_mask(test::kShape, {{60, 20}, {90, 20}, {90, 50}, {60, 50}});
    const grid::Mask there =
        transformed(mask, in_cells(Transform{.move_x_mm = 7.5, .move_y_mm = -3.25}, test::kCell_mm));
    EXPECT_EQ(grid::chosen_area(there), (grid::Rect{90, 7, 120, 37}));
    EXPECT_EQ(grid::chosen_cells(there), 900);
}

}  // namespace
}  // namespace pastoso::layers
