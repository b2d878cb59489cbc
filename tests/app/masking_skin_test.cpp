#include "view/masking_skin.hpp"

#include <gtest/gtest.h>

namespace pastoso::view {
namespace {

document::Masking masking_of(grid::Mask cells) {
    return {std::make_shared<const grid::Mask>(std::move(cells))};
}

TEST(MaskingSkin, IsThereWhereTheCanvasIsMasked) {
    grid::Mask cells({7, 3});
    cells.set(4, 1, grid::kWhole);
    MaskingSkin skin;
    const QImage picture = skin.picture(masking_of(cells));
    ASSERT_EQ(picture.size(), QSize(7, 3));
    for (int y = 0; y < 3; ++y)
        for (int x = 0; x < 7; ++x)
            EXPECT_EQ(qAlpha(picture.pixel(x, y)) > 0, x == 4 && y == 1) << x << ", " << y;
    EXPECT_LT(qAlpha(picture.pixel(4, 1)), 200) << "paint shows through";
    EXPECT_TRUE(skin.picture({}).isNull());
}

TEST(MaskingSkin, OfALargeCanvasIsCoarser) {
    grid::Mask cells({5000, 10});
    for (int x = 2500; x < 5000; ++x)
        for (int y = 0; y < 10; ++y)
            cells.set(x, y, grid::kWhole);
    MaskingSkin skin;
    const QImage picture = skin.picture(masking_of(cells));
    EXPECT_EQ(picture.size(), QSize(1667, 4));
    EXPECT_EQ(qAlpha(picture.pixel(800, 2)), 0);
    EXPECT_GT(qAlpha(picture.pixel(900, 2)), 0);
}

TEST(MaskingSkin, HasLightAndDarkStripes) {
    grid::Mask cells({64, 64}, grid::kWhole);
    MaskingSkin skin;
    const QImage picture = skin.picture(masking_of(cells));
    EXPECT_NE(picture.pixel(0, 0), picture.pixel(6, 0));
    EXPECT_EQ(picture.pixel(0, 0), picture.pixel(12, 0));
}

}  // namespace
}  // namespace pastoso::view
