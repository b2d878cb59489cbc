// Layers that are drawn by the corners of a rectangle.
#include "layers/random_layer.hpp"
#include "layers/sums.hpp"
#include "layers/transform.hpp"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

namespace pastoso::layers {
namespace {

using film::FilmState;
using test::kCell_mm;
using test::kShape;

/// The rectangle of cells from (x0, y0) to (x1, y1), drawn by its corners.
Distortion distortion(int x0, int y0, int x1, int y1, const Corners& corners_cells) {
    const auto place = [](double x, double y) { return Place{kCell_mm * x, kCell_mm * y}; };
    const auto corner = [&](int k) { return place(corners_cells[k].x, corners_cells[k].y); };
    return {place(x0, y0), kCell_mm * (x1 - x0), kCell_mm * (y1 - y0), corner(0), corner(1), corner(2),
            corner(3)};
}

class Distorting : public testing::Test {
  protected:
    FilmState distorted(const FilmState& layer, const Distortion& by) {
        return transformed(layer, in_cells(by, kCell_mm), pool);
    }
    FilmState transformed_by(const FilmState& layer, const Transform& by) {
        return transformed(layer, in_cells(by, kCell_mm), pool);
    }
    static FilmState slab(int x0, int y0, int x1, int y1) {
        FilmState layer = test::bare_layer();
        for (int y = y0; y < y1; ++y)
            for (int x = x0; x < x1; ++x)
                film::test::lay(layer, x, y, 0.5, film::test::kBlue,
                                film::find_medium("heavy-body oil"));
        return layer;
    }
    static double volume(const FilmState& layer) {
        return static_cast<double>(film::totals(layer).thickness +
                                   film::dried_totals(layer.strata).thickness);
    }
    /// The middle of what lies on it, in cells.
    static grid::Point middle(const FilmState& layer) {
        double sum = 0.0;
        grid::Point sums;
        for (int y = 0; y < layer.shape.height; ++y)
            for (int x = 0; x < layer.shape.width; ++x) {
                const double thickness = layer.thickness.at(x, y);
                sum += thickness;
                sums.x += thickness * (x + 0.5);
                sums.y += thickness * (y + 0.5);
            }
        return {sums.x / sum, sums.y / sum};
    }

    core::ThreadPool pool{2};
    const Corners far_above{{{50, 10}, {80, 14}, {110, 60}, {30, 66}}};  ///< in perspective
};

TEST_F(Distorting, CornersThatStayLeaveEverythingAsItIs) {
    for (const std::uint32_t seed : {2U, 3U}) {
        const FilmState layer = test::random_layer(seed);
        const Distortion still = distortion(13, 5, 100, 66, {{{13, 5}, {100, 5}, {100, 66}, {13, 66}}});
        EXPECT_EQ(film::state_hash(distorted(layer, still)), film::state_hash(layer));
    }
}

TEST_F(Distorting, CornersThatMoveTogetherMoveTheLayer) {
    const FilmState layer = test::random_layer(2);
    EXPECT_EQ(film::state_hash(distorted(
                  layer, distortion(13, 5, 100, 66, {{{43, -8}, {130, -8}, {130, 53}, {43, 53}}}))),
              film::state_hash(transformed_by(layer, {.move_x_mm = 7.5, .move_y_mm = -3.25})));
}

TEST_F(Distorting, CornersThatChangePlacesMirrorAndTurnIt) {
    const FilmState layer = test::random_layer(4);
    const Transform mirror{.centre_x_mm = kCell_mm * 60, .centre_y_mm = kCell_mm * 35, .scale_x = -1.0};
    EXPECT_EQ(film::state_hash(distorted(
                  layer, distortion(40, 20, 80, 50, {{{80, 20}, {40, 20}, {40, 50}, {80, 50}}}))),
              film::state_hash(transformed_by(layer, mirror)));
    const Transform turn{.centre_x_mm = kCell_mm * 60, .centre_y_mm = kCell_mm * 35, .turn_deg = 90.0};
    EXPECT_EQ(film::state_hash(distorted(
                  layer, distortion(45, 20, 75, 50, {{{75, 20}, {75, 50}, {45, 50}, {45, 20}}}))),
              film::state_hash(transformed_by(layer, turn)));
}

TEST_F(Distorting, AScaledRectangleIsScaled) {
    const FilmState layer = test::random_layer(5);
    const FilmState one =
        distorted(layer, distortion(40, 20, 80, 50, {{{30, 23}, {90, 23}, {90, 47}, {30, 47}}}));
    const FilmState other = transformed_by(
        layer,
        {.centre_x_mm = kCell_mm * 60, .centre_y_mm = kCell_mm * 35, .scale_x = 1.5, .scale_y = 0.8});
    // Shares differ in the last bits, and thicknesses then by a quantum here and there.
    for (int y = 0; y < kShape.height; ++y)
        for (int x = 0; x < kShape.width; ++x)
            ASSERT_NEAR(one.thickness.at(x, y), other.thickness.at(x, y), 1) << x << ", " << y;
    EXPECT_NEAR(volume(one) / volume(other), 1.0, 1e-9);
}

TEST_F(Distorting, AnEvenSlabKeepsItsThicknessInPerspective) {
    const FilmState layer = slab(40, 10, 110, 60);
    const FilmState there = distorted(layer, distortion(40, 10, 110, 60, far_above));
    for (int y = 24; y < 58; ++y)
        for (int x = 55; x < 80; ++x) {
            ASSERT_EQ(there.thickness.at(x, y), layer.thickness.at(75, 35));
            ASSERT_EQ(there.paint.at(x, y), layer.paint.at(75, 35));
        }
    double area = 0.0;
    for (int k = 0; k < 4; ++k)
        area += 0.5 *
                (far_above[k].x * far_above[(k + 1) % 4].y - far_above[(k + 1) % 4].x * far_above[k].y);
    // Its edges are blurred over a cell, evenly to both sides.
    EXPECT_NEAR(volume(there) / volume(layer), area / (70.0 * 50.0), 0.003);
}

TEST_F(Distorting, PaintComesWhereTheMapTakesIt) {
    const Distortion by = distortion(40, 10, 110, 60, far_above);
    for (const auto& [x, y] : {std::pair{50, 16}, std::pair{90, 40}, std::pair{60, 55}}) {
        const FilmState there = distorted(slab(x, y, x + 3, y + 3), by);
        const grid::Point wanted = in_cells(by, kCell_mm)(x + 1.5, y + 1.5);
        EXPECT_NEAR(middle(there).x, wanted.x, 0.3);
        EXPECT_NEAR(middle(there).y, wanted.y, 0.3);
    }
}

TEST_F(Distorting, ThereAndBackGivesTheVolumeBack) {
    const FilmState layer = slab(50, 15, 100, 55);
    const Distortion there = distortion(50, 15, 100, 55, far_above);
    // Of the rectangle around where it came to.
    const Projective from = inverse(in_cells(there, kCell_mm));
    const Distortion again =
        distortion(30, 10, 110, 66, {{from(30, 10), from(110, 10), from(110, 66), from(30, 66)}});
    const FilmState back = distorted(distorted(layer, there), again);
    // Four edges of some 50 cells, blurred over a cell each time.
    EXPECT_NEAR(volume(back) / volume(layer), 1.0, 0.01);
    EXPECT_EQ(back.thickness.at(75, 35), layer.thickness.at(75, 35));
    EXPECT_EQ(back.thickness.at(56, 22), layer.thickness.at(56, 22));
    EXPECT_EQ(back.thickness.at(40, 35), 0);
}

TEST_F(Distorting, CarriesPaintOfEveryKind) {
    const FilmState layer = test::random_layer(7);
    const FilmState there =
        distorted(layer, distortion(0, 0, 120, 70, {{{20, 5}, {100, 10}, {120, 65}, {10, 60}}}));
    ASSERT_TRUE(layer.media.are_several());
    EXPECT_TRUE(there.media.are_several());
    const film::Totals wet_before = film::totals(layer), wet = film::totals(there);
    const double share = static_cast<double>(wet.thickness) / static_cast<double>(wet_before.thickness);
    EXPECT_GT(share, 0.5);
    EXPECT_LT(share, 0.8);
    for (int k = 0; k < film::kPigmentChannels; ++k) {
        const auto before = static_cast<double>(wet_before.paint[k]);
        // A layer of noise, seen nearer here and farther there.
        EXPECT_NEAR(static_cast<double>(wet.paint[k]), share * before, 0.1 * share * before + 2000.0)
            << k;
    }
    EXPECT_GT(film::dried_totals(there.strata).thickness, 0);
    EXPECT_EQ(there.strata.evaporated, layer.strata.evaporated);
}

TEST_F(Distorting, WhatComesBeyondTheCanvasIsGone) {
    const FilmState layer = slab(40, 10, 110, 60);
    const FilmState gone =
        distorted(layer, distortion(40, 10, 110, 60, {{{500, 10}, {580, 14}, {510, 60}, {430, 66}}}));
    EXPECT_EQ(test::sums_of(gone), test::sums_of(test::bare_layer()));
    const FilmState part =
        distorted(layer, distortion(40, 10, 110, 60, {{{-900, -700}, {140, 5}, {1200, 900}, {30, 66}}}));
    EXPECT_GT(volume(part), 0.0);
    EXPECT_LE(volume(part),
              static_cast<double>(layer.thickness.at(75, 35)) * kShape.width * kShape.height);
}

TEST_F(Distorting, WhatLiesBehindTheHorizonIsGone) {
    // Lines upwards meet at the row 0, where what is drawn out of the rectangle would come to lie.
    const FilmState layer = slab(0, 0, 150, 70);
    const FilmState there =
        distorted(layer, distortion(40, 30, 110, 70, {{{70, 20}, {80, 20}, {110, 65}, {40, 65}}}));
    for (int x = 0; x < kShape.width; ++x) {
        EXPECT_EQ(there.thickness.at(x, 5), 0) << x;
        EXPECT_LE(there.thickness.at(x, 40), layer.thickness.at(75, 35)) << x;
    }
    EXPECT_EQ(there.thickness.at(75, 40), layer.thickness.at(75, 35));
}

TEST_F(Distorting, IsTheSameOnAnyNumberOfThreads) {
    core::ThreadPool alone(1), three(3);
    const FilmState layer = test::random_layer(7);
    const Projective map = in_cells(distortion(0, 0, 120, 70, far_above), kCell_mm);
    EXPECT_EQ(film::state_hash(transformed(layer, map, alone)),
              film::state_hash(transformed(layer, map, three)));
}

TEST_F(Distorting, AMaskComesAlong) {
    const grid::Mask mask = grid::polygon_mask(kShape, {{40, 10}, {110, 10}, {110, 60}, {40, 60}});
    const grid::Mask there =
        transformed(mask, in_cells(distortion(40, 10, 110, 60, far_above), kCell_mm));
    const grid::Mask wanted = grid::polygon_mask(kShape, {far_above.begin(), far_above.end()});
    // The middles of two cells lie on an edge.
    EXPECT_LE(grid::chosen_cells(grid::combined(there, wanted, grid::Combination::Subtract)), 2);
    EXPECT_LE(grid::chosen_cells(grid::combined(wanted, there, grid::Combination::Subtract)), 2);
}

}  // namespace
}  // namespace pastoso::layers
