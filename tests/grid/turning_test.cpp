#include "grid/turning.hpp"

#include <gtest/gtest.h>

namespace pastoso::grid {
namespace {

using core::Orientation;

constexpr Shape kShape = {200, 150};

class FieldTurning : public testing::Test {
  protected:
    /// Every cell another number; the lower right tiles are left background.
    static TiledField<int> numbered() {
        TiledField<int> field(kShape, -1);
        for (int y = 0; y < kShape.height; ++y)
            for (int x = 0; x < kShape.width; ++x)
                if (x < 64 || y < 64) field.set(x, y, 1000 * y + x);
        return field;
    }
    TiledField<int> turned_field(const TiledField<int>& field, const Orientation& turn) {
        TiledField<int> result(turned(field.shape(), turn), -1);
        put_turned(field, turn, result, pool);
        return result;
    }

    core::ThreadPool pool{2};
};

TEST_F(FieldTurning, EveryCellComesToItsPlace) {
    const TiledField<int> field = numbered();
    const TiledField<int> mirrored = turned_field(field, {true, 0}),
                          right = turned_field(field, {false, 1});
    EXPECT_EQ(mirrored.shape(), kShape);
    EXPECT_EQ(right.shape(), (Shape{150, 200}));
    for (int y = 0; y < kShape.height; ++y)
        for (int x = 0; x < kShape.width; ++x) {
            ASSERT_EQ(mirrored.at(kShape.width - 1 - x, y), field.at(x, y)) << x << ", " << y;
            ASSERT_EQ(right.at(kShape.height - 1 - y, x), field.at(x, y)) << x << ", " << y;
        }
}

TEST_F(FieldTurning, BareTilesCostNothing) {
    const TiledField<int> around = turned_field(numbered(), {false, 2});
    EXPECT_TRUE(around.is_background(0));
    EXPECT_TRUE(around.is_background(1));
    EXPECT_FALSE(around.is_background(3));
}

TEST_F(FieldTurning, ATileOfNowIsSuchAsAnyThatItsCellsWereIn) {
    std::vector<bool> tiles(12);
    tiles[0] = true;
    // 200 cells are three tiles and 8 cells: the first tile's last 8 come to lie in the third.
    EXPECT_EQ(turned_tiles(tiles, kShape, {true, 0}),
              (std::vector<bool>{false, false, true, true, false, false, false, false, false, false,
                                 false, false}));
    EXPECT_EQ(turned_tiles(tiles, kShape, {false, 1}),
              (std::vector<bool>{false, true, true, false, false, false, false, false, false, false,
                                 false, false}));
}

}  // namespace
}  // namespace pastoso::grid
