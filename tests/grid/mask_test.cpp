#include "grid/mask.hpp"

#include "core/random.hpp"
#include "grid/drawn_mask.hpp"

#include <cmath>

#include <gtest/gtest.h>

namespace pastoso::grid {
namespace {

constexpr Shape kSmall = {6, 4};

/// How often the outline winds around a point, from the angles under which its edges are seen.
int winding(const std::vector<Point>& outline, double x, double y) {
    double angle = 0.0;
    for (std::size_t i = 0; i < outline.size(); ++i) {
        const Point& a = outline[i];
        const Point& b = outline[(i + 1) % outline.size()];
        const double ax = a.x - x, ay = a.y - y, bx = b.x - x, by = b.y - y;
        angle += std::atan2(ax * by - ay * bx, ax * bx + ay * by);
    }
    return static_cast<int>(std::lround(angle / (2.0 * 3.14159265358979)));
}

std::vector<Point> random_outline(std::uint32_t seed, double size) {
    std::vector<Point> outline;
    for (std::uint32_t i = 0; i < 3 + seed % 9; ++i)
        outline.push_back({size * (1.4 * core::uniform_noise(2 * i, seed) - 0.2),
                           size * (1.4 * core::uniform_noise(2 * i + 1, seed) - 0.2)});
    return outline;
}

TEST(PolygonMask, HoldsTheCellsWhoseCentresItGoesAround) {
    EXPECT_EQ(drawn(polygon_mask(kSmall, {{1, 1}, {4, 1}, {4, 3}, {1, 3}})),
              "......\n"
              ".###..\n"
              ".###..\n"
              "......\n");
    EXPECT_EQ(drawn(polygon_mask(kSmall, {{0, 0}, {0, 4}, {4, 4}})),
              "......\n"
              "#.....\n"
              "##....\n"
              "###...\n");
}

TEST(PolygonMask, ASharedEdgeDividesTheCellsWithoutGapOrOverlap) {
    const Mask left = polygon_mask(kSmall, {{0, 0}, {2.5, 0}, {3.5, 4}, {0, 4}});
    const Mask right = polygon_mask(kSmall, {{2.5, 0}, {6, 0}, {6, 4}, {3.5, 4}});
    EXPECT_EQ(chosen_cells(combined(left, right, Combination::Add)), 24);
    EXPECT_EQ(chosen_cells(combined(left, right, Combination::Intersect)), 0);
}

TEST(PolygonMask, AFigureOfEightHoldsBothLoops) {
    EXPECT_EQ(drawn(polygon_mask(kSmall, {{0, 0}, {6, 4}, {6, 0}, {0, 4}})),
              drawn(polygon_mask(kSmall, {{0, 4}, {6, 0}, {6, 4}, {0, 0}})));
    EXPECT_EQ(chosen_cells(polygon_mask(kSmall, {{0, 0}, {6, 4}, {6, 0}, {0, 4}})), 12);
}

TEST(PolygonMask, AgreesWithAnglesForRandomOutlines) {
    const Shape shape = {90, 70};
    for (std::uint32_t seed = 1; seed <= 40; ++seed) {
        const std::vector<Point> outline = random_outline(seed, 90.0);
        const Mask mask = polygon_mask(shape, outline);
        for (int y = 0; y < shape.height; ++y)
            for (int x = 0; x < shape.width; ++x)
                ASSERT_EQ(mask.at(x, y) != 0, winding(outline, x + 0.5, y + 0.5) != 0)
                    << "outline " << seed << " at " << x << ", " << y;
    }
}

TEST(PolygonMask, OneThatLiesBesideTheCanvasHoldsNothing) {
    const Mask mask = polygon_mask({100, 100}, {{-50, -50}, {-10, -50}, {-10, 1e5}, {-50, 1e5}});
    EXPECT_EQ(chosen_cells(mask), 0);
    EXPECT_TRUE(chosen_area(mask).empty());
    EXPECT_EQ(chosen_cells(polygon_mask({100, 100}, {{3, 3}, {90, 90}})), 0);
}

TEST(Masks, CombineCellByCell) {
    const Mask a = polygon_mask({2, 1}, {{0, 0}, {1, 0}, {1, 1}, {0, 1}});
    const Mask both = polygon_mask({2, 1}, {{0, 0}, {2, 0}, {2, 1}, {0, 1}});
    EXPECT_EQ(drawn(combined(a, both, Combination::Replace)), "##\n");
    EXPECT_EQ(drawn(combined(a, both, Combination::Add)), "##\n");
    EXPECT_EQ(drawn(combined(both, a, Combination::Subtract)), ".#\n");
    EXPECT_EQ(drawn(combined(a, both, Combination::Subtract)), "..\n");
    EXPECT_EQ(drawn(combined(both, a, Combination::Intersect)), "#.\n");
    EXPECT_EQ(drawn(inverted(a)), ".#\n");
    EXPECT_EQ(drawn(inverted(inverted(a))), "#.\n");
}

/// A row of shares.
Mask shares(const std::vector<int>& row) {
    Mask mask({static_cast<int>(row.size()), 1});
    for (int x = 0; x < mask.shape().width; ++x)
        mask.set(x, 0, static_cast<std::uint8_t>(row[static_cast<std::size_t>(x)]));
    return mask;
}

std::vector<int> row_of(const Mask& mask) {
    std::vector<int> row;
    for (int x = 0; x < mask.shape().width; ++x)
        row.push_back(mask.at(x, 0));
    return row;
}

TEST(Masks, SharesCombineByTheLargerTheSmallerAndTheirDifference) {
    const Mask a = shares({0, 100, 100, 255, 255}), b = shares({30, 30, 200, 30, 255});
    using Row = std::vector<int>;
    EXPECT_EQ(row_of(combined(a, b, Combination::Replace)), (Row{30, 30, 200, 30, 255}));
    EXPECT_EQ(row_of(combined(a, b, Combination::Add)), (Row{30, 100, 200, 255, 255}));
    EXPECT_EQ(row_of(combined(a, b, Combination::Intersect)), (Row{0, 30, 100, 30, 255}));
    EXPECT_EQ(row_of(combined(a, b, Combination::Subtract)), (Row{0, 70, 0, 225, 0}));
    EXPECT_EQ(row_of(combined(inverted(Mask({5, 1})), b, Combination::Subtract)), row_of(inverted(b)));
    EXPECT_EQ(row_of(inverted(a)), (Row{255, 155, 155, 0, 0}));
}

TEST(Masks, OneHalfIsChosen) {
    const Mask mask = shares({0, 1, 127, 128, 254, 255});
    EXPECT_EQ(chosen_cells(mask), 3);
    EXPECT_EQ(chosen_area(mask), (Rect{1, 0, 6, 1})) << "by any share";
    EXPECT_EQ(row_of(hardened(mask)), (std::vector<int>{0, 0, 0, 255, 255, 255}));
    EXPECT_EQ(chosen_cells(inverted(mask)), 3);
    EXPECT_TRUE(is_soft(mask));
    EXPECT_FALSE(is_soft(hardened(mask)));
    EXPECT_FALSE(is_soft(Mask({6, 1})));
}

TEST(Masks, AShareOfAnAmountIsRoundedTowardsNothing) {
    EXPECT_EQ(share_of(1000, 0), 0);
    EXPECT_EQ(share_of(1000, kWhole), 1000);
    EXPECT_EQ(share_of(1000, 51), 200);
    EXPECT_EQ(share_of(1001, 51), 200);
    EXPECT_EQ(share_of(-1001, 51), -200);
    EXPECT_EQ(share_of(2'000'000'000, 254), 1'992'156'862);
    EXPECT_EQ(fraction_of(kWhole), 1.0F);
}

TEST(Masks, LargeOnesCostOneTile) {
    const Mask most = polygon_mask({640, 640}, {{0, 0}, {640, 0}, {640, 640}, {320, 640}, {0, 320}});
    EXPECT_TRUE(chooses_all(most, 0));
    EXPECT_TRUE(chooses_none(most, 90));
    EXPECT_EQ(bytes_in_part(most), 5U * kTileCells);  // along the slanting edge
    for (int tile = 1; tile < 10; ++tile)
        EXPECT_EQ(most.block(tile), most.block(0)) << tile;
    EXPECT_EQ(chosen_area(most), (Rect{0, 0, 640, 640}));
    EXPECT_EQ(chosen_cells(most) + chosen_cells(inverted(most)), 640 * 640);
}

}  // namespace
}  // namespace pastoso::grid
