#include "grid/mask_margins.hpp"

#include "core/random.hpp"
#include "grid/connected.hpp"
#include "grid/drawn_mask.hpp"

#include <cmath>

#include <gtest/gtest.h>

namespace pastoso::grid {
namespace {

/// More than one tile, and none of them whole.
constexpr Shape kOdd = {71, 67};

Mask random_mask(Shape shape, std::uint32_t seed, float share) {
    Mask mask(shape);
    for (int y = 0; y < shape.height; ++y)
        for (int x = 0; x < shape.width; ++x)
            if (core::uniform_noise(static_cast<std::uint32_t>(y * shape.width + x), seed) < share)
                mask.set(x, y, kWhole);
    return mask;
}

/// By looking at all pairs of cells.
bool is_near_a_chosen_one(const Mask& mask, int x, int y, double reach) {
    const double radius2 = (reach + 0.5) * (reach + 0.5);
    for (int j = 0; j < mask.shape().height; ++j)
        for (int i = 0; i < mask.shape().width; ++i)
            if (mask.at(i, j) != 0 && (i - x) * (i - x) + (j - y) * (j - y) <= radius2) return true;
    return false;
}

Mask mirrored(const Mask& mask) {
    Mask other(mask.shape());
    for (int y = 0; y < mask.shape().height; ++y)
        for (int x = 0; x < mask.shape().width; ++x)
            other.set(mask.shape().width - 1 - x, mask.shape().height - 1 - y, mask.at(x, y));
    return other;
}

TEST(MaskMargins, AreRoundAboutACell) {
    Mask dot({9, 7});
    dot.set(4, 3, kWhole);
    EXPECT_EQ(drawn(grown(dot, 2.0)),
              ".........\n"
              "...###...\n"
              "..#####..\n"
              "..#####..\n"
              "..#####..\n"
              "...###...\n"
              ".........\n");
    EXPECT_EQ(drawn(grown(dot, 0.49)), drawn(dot));
    Mask corner({9, 7});
    corner.set(8, 0, kWhole);
    EXPECT_EQ(chosen_cells(grown(corner, 1e6)), 9 * 7);
    EXPECT_EQ(chosen_cells(grown(corner, 9.4)), 9 * 7 - 1) << "8 and 6 make 10";
}

TEST(MaskMargins, ARectangleGrowsByWholeCells) {
    const Mask box = polygon_mask({20, 16}, {{6, 6}, {12, 6}, {12, 10}, {6, 10}});
    const Mask wider = grown(box, 3.0);
    EXPECT_EQ(chosen_area(wider), (Rect{3, 3, 15, 13}));
    EXPECT_EQ(wider.at(3, 3), 0) << "its corners are round";
    EXPECT_EQ(chosen_area(shrunk(box, 1.0)), (Rect{7, 7, 11, 9}));
    EXPECT_EQ(chosen_cells(shrunk(box, 2.0)), 0);
    EXPECT_EQ(chosen_cells(along_outline(box, 1.0)), 8 * 6 - 4 * 2);
}

TEST(MaskMargins, TakeOfSoftEdgesWhatIsChosenByHalf) {
    Mask soft({20, 16});
    for (int y = 4; y < 12; ++y)
        for (int x = 4; x < 16; ++x)
            soft.set(x, y, static_cast<std::uint8_t>(16 * x));
    const Mask hard = hardened(soft);
    for (const double reach : {1.0, 2.0}) {
        EXPECT_EQ(drawn(grown(soft, reach)), drawn(grown(hard, reach)));
        EXPECT_EQ(drawn(shrunk(soft, reach)), drawn(shrunk(hard, reach)));
        EXPECT_EQ(drawn(along_outline(soft, reach)), drawn(along_outline(hard, reach)));
        EXPECT_FALSE(is_soft(grown(soft, reach)) || is_soft(shrunk(soft, reach)) ||
                     is_soft(along_outline(soft, reach)));
    }
    EXPECT_EQ(chosen_area(grown(soft, 1.0)).x0, 7) << "128 is one half, at 8";
}

TEST(MaskMargins, AreThoseOfAllDistances) {
    for (const double reach : {0.0, 0.5, 1.0, 2.3, 7.0, 19.4}) {
        const Mask mask = random_mask(kOdd, 3, 0.004F);
        const Mask wider = grown(mask, reach);
        for (int y = 0; y < kOdd.height; ++y)
            for (int x = 0; x < kOdd.width; ++x)
                ASSERT_EQ(wider.at(x, y) != 0, is_near_a_chosen_one(mask, x, y, reach))
                    << reach << ": " << x << ", " << y;
    }
}

TEST(MaskMargins, OfAMirroredMaskAreMirrored) {
    const Mask mask = random_mask(kOdd, 8, 0.01F);
    EXPECT_EQ(drawn(mirrored(grown(mask, 4.2))), drawn(grown(mirrored(mask), 4.2)));
    EXPECT_EQ(drawn(mirrored(shrunk(mask, 1.0))), drawn(shrunk(mirrored(mask), 1.0)));
}

TEST(MaskMargins, TheEdgeOfTheCanvasIsNoOutline) {
    const Mask half = polygon_mask({10, 6}, {{0, 0}, {5, 0}, {5, 6}, {0, 6}});
    EXPECT_EQ(chosen_area(shrunk(half, 2.0)), (Rect{0, 0, 3, 6}));
    EXPECT_EQ(chosen_area(along_outline(half, 2.0)), (Rect{3, 0, 7, 6}));
    const Mask all = inverted(Mask({10, 6}));
    EXPECT_EQ(chosen_cells(shrunk(all, 3.0)), 60);
    EXPECT_EQ(chosen_cells(grown(Mask({10, 6}), 3.0)), 0);
}

TEST(MaskMargins, ADiscGrowsToTheAreaOfALargerOneAtAnyResolution) {
    for (const int cells_per_mm : {2, 5, 20}) {
        const int side = 30 * cells_per_mm;
        std::vector<Point> circle;
        for (int i = 0; i < 720; ++i)
            circle.push_back({(15.0 + 8.0 * std::cos(i * 0.0087266)) * cells_per_mm,
                              (15.0 + 8.0 * std::sin(i * 0.0087266)) * cells_per_mm});
        const Mask disc = polygon_mask({side, side}, circle);
        const auto area_mm2 = [&](const Mask& mask) {
            return static_cast<double>(chosen_cells(mask)) / (cells_per_mm * cells_per_mm);
        };
        // Outlines of cells are uncertain by half a cell.
        const auto uncertain_mm2 = [&](double radius_mm) {
            return 2.0 * 3.1416 * radius_mm * 0.5 / cells_per_mm;
        };
        EXPECT_NEAR(area_mm2(grown(disc, 3.0 * cells_per_mm)), 3.1416 * 121.0, uncertain_mm2(11.0));
        EXPECT_NEAR(area_mm2(shrunk(disc, 3.0 * cells_per_mm)), 3.1416 * 25.0, uncertain_mm2(5.0));
    }
}

TEST(ConnectedCells, HangTogetherBySides) {
    Mask mask({6, 4});
    for (const auto& [x, y] : {std::pair{0, 0}, {1, 0}, {1, 1}, {1, 2}, {2, 2}, {3, 3}, {5, 0}, {4, 2}})
        mask.set(x, y, kWhole);
    EXPECT_EQ(drawn(connected(mask, 2, 2)),
              "##....\n"
              ".#....\n"
              ".##...\n"
              "......\n");
    EXPECT_EQ(drawn(connected(mask, 3, 3)),
              "......\n"
              "......\n"
              "......\n"
              "...#..\n");
    EXPECT_EQ(chosen_cells(connected(mask, 3, 0)), 0);
}

TEST(ConnectedCells, AreFoundAroundCornersAndAcrossTiles) {
    Mask spiral({140, 9});
    for (int x = 0; x < 140; ++x)
        for (const int y : {0, 4, 8})
            spiral.set(x, y, kWhole);
    for (int y = 0; y < 9; ++y)
        spiral.set(y < 4 ? 139 : 0, y, kWhole);
    spiral.set(70, 2, kWhole);
    EXPECT_EQ(chosen_cells(connected(spiral, 3, 0)), chosen_cells(spiral) - 1);
    EXPECT_EQ(chosen_cells(connected(spiral, 70, 2)), 1);
    const Mask speckles = random_mask(kOdd, 5, 0.7F);
    EXPECT_EQ(drawn(mirrored(connected(speckles, 35, 33))),
              drawn(connected(mirrored(speckles), 35, 33)));
}

}  // namespace
}  // namespace pastoso::grid
