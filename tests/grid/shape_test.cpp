#include "grid/shape.hpp"

#include <vector>

#include <gtest/gtest.h>

namespace {

using namespace pastoso::grid;  // NOLINT(google-build-using-namespace)

TEST(Rect, IntersectionAndBoundingBox) {
    const Rect a{0, 0, 10, 5};
    const Rect b{4, -2, 20, 3};
    EXPECT_EQ(intersection(a, b), (Rect{4, 0, 10, 3}));
    EXPECT_EQ(bounding_box(a, b), (Rect{0, -2, 20, 5}));
    EXPECT_TRUE(intersection(a, {10, 0, 12, 5}).empty());
}

TEST(Rect, AnEmptyOneAddsNothingToABoundingBox) {
    const Rect a{3, 4, 5, 6};
    EXPECT_EQ(bounding_box(a, {}), a);
    EXPECT_EQ(bounding_box({}, a), a);
}

TEST(Shape, CountsTilesThatReachBeyondTheCanvas) {
    EXPECT_EQ((Shape{64, 64}.tile_count()), 1);
    EXPECT_EQ((Shape{65, 64}.tile_count()), 2);
    EXPECT_EQ((Shape{1, 129}.tile_count()), 3);
}

TEST(Shape, EveryCellLiesInOneTileAtAPlaceOfItsOwn) {
    const Shape shape{130, 70};
    std::vector<int> seen(static_cast<std::size_t>(shape.tile_count()) * kTileCells);
    for (int y = 0; y < shape.height; ++y) {
        for (int x = 0; x < shape.width; ++x) {
            const int tile = shape.tile_at(x, y);
            const Rect cells = shape.tile_cells(tile);
            EXPECT_TRUE(x >= cells.x0 && x < cells.x1 && y >= cells.y0 && y < cells.y1);
            EXPECT_EQ(++seen[static_cast<std::size_t>(tile) * kTileCells + Shape::cell_in_tile(x, y)],
                      1);
        }
    }
}

TEST(Shape, TileCellsAreCutAtTheCanvas) {
    const Shape shape{130, 70};
    EXPECT_EQ(shape.tile_cells(0), (Rect{0, 0, 64, 64}));
    EXPECT_EQ(shape.tile_cells(5), (Rect{128, 64, 130, 70}));
}

TEST(Shape, TilesTouchingARectangle) {
    const Shape shape{200, 200};
    EXPECT_EQ(shape.tiles_touching({0, 0, 64, 64}), (Rect{0, 0, 1, 1}));
    EXPECT_EQ(shape.tiles_touching({63, 64, 65, 65}), (Rect{0, 1, 2, 2}));
    EXPECT_EQ(shape.tiles_touching({-50, 190, 500, 500}), (Rect{0, 2, 4, 4}));
    EXPECT_TRUE(shape.tiles_touching({300, 0, 310, 10}).empty());
}

}  // namespace
