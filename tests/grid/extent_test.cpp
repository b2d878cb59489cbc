#include "grid/extent.hpp"

#include <gtest/gtest.h>

namespace pastoso::grid {
namespace {

constexpr Shape kShape = {200, 150};

/// Every cell another number; one tile is left background.
TiledField<int> numbered() {
    TiledField<int> field(kShape, -1);
    for (int y = 0; y < kShape.height; ++y)
        for (int x = 0; x < kShape.width; ++x)
            if (kShape.tile_at(x, y) != 5) field.set(x, y, 1000 * y + x);
    return field;
}

void expect_moved(const Extent& extent) {
    const TiledField<int> field = numbered();
    TiledField<int> result(extent.shape, -1);
    put_on_extent(field, extent, result);
    for (int y = 0; y < extent.shape.height; ++y)
        for (int x = 0; x < extent.shape.width; ++x) {
            const int from_x = x + extent.x0, from_y = y + extent.y0;
            const int expected = kShape.contains(from_x, from_y) ? field.at(from_x, from_y) : -1;
            ASSERT_EQ(result.at(x, y), expected) << x << ", " << y;
        }
}

TEST(Extents, CutAddAndShift) {
    expect_moved({kShape});
    expect_moved({{90, 70}, 31, 17});
    expect_moved({{300, 260}, -40, -77});
    expect_moved({{100, 300}, 128, -64});
    expect_moved({{64, 64}, 64, 64});
    expect_moved({{50, 50}, 1000, 0});
    expect_moved({{50, 50}, -51, 0});
}

TEST(Extents, WholeTilesAreShared) {
    const TiledField<int> field = numbered();
    const Extent extent{{192, 192}, -64, 64};
    TiledField<int> result(extent.shape, -1);
    put_on_extent(field, extent, result);
    EXPECT_TRUE(result.block(1) == field.block(4));
    EXPECT_TRUE(result.is_background(0));
    EXPECT_TRUE(result.is_background(2)) << "tile 5 of the field, which is background";
}

}  // namespace
}  // namespace pastoso::grid
