#include "shade/picture_sheet.hpp"

#include <gmock/gmock.h>

namespace pastoso::shade {
namespace {

pigment::Image8 grey(int width, int height, std::vector<int> values) {
    pigment::Image8 image{width, height, {}};
    for (const int value : values)
        image.rgb.insert(image.rgb.end(), 3, static_cast<std::uint8_t>(value));
    return image;
}

TEST(PictureSheet, EnlargingInterpolatesBetweenPixelCentres) {
    const pigment::Image8 large = enlarged(grey(2, 1, {0, 80}), 4);
    // Centres at 2 and 6: the pixels at 2.5, 3.5, ... lie 1/8, 3/8, ... of the way between them.
    EXPECT_EQ(large.rgb, grey(8, 4, {0, 0, 10, 30, 50, 70, 80, 80, 0, 0, 10, 30, 50, 70, 80, 80,
                                     0, 0, 10, 30, 50, 70, 80, 80, 0, 0, 10, 30, 50, 70, 80, 80})
                             .rgb);
    const pigment::Image8 same = grey(3, 2, {1, 2, 3, 4, 5, 6});
    EXPECT_EQ(enlarged(same, 1).rgb, same.rgb);
}

TEST(PictureSheet, PicturesStandInRowsWithWhiteBetween) {
    const pigment::Image8 sheet =
        arranged({{grey(1, 1, {10}), grey(2, 1, {20, 30})}, {grey(1, 2, {40, 50})}}, 1);
    EXPECT_EQ(sheet.width, 4);
    EXPECT_EQ(sheet.height, 4);
    EXPECT_EQ(
        sheet.rgb,
        grey(4, 4, {10, 255, 20, 30, 255, 255, 255, 255, 40, 255, 255, 255, 50, 255, 255, 255}).rgb);
}

TEST(PictureSheet, AFrameHoldsThePictureInItsMiddle) {
    const pigment::LinearImage picture{2, 1, {1, 2, 3, 4, 5, 6}};
    const pigment::LinearImage wide = framed(picture, 4, 1);
    EXPECT_THAT(wide.rgb,
                testing::ElementsAre(0.18F, 0.18F, 0.18F, 1, 2, 3, 4, 5, 6, 0.18F, 0.18F, 0.18F));
    EXPECT_EQ(framed(picture, 2, 1).rgb, picture.rgb);
    EXPECT_THAT(framed({3, 1, {1, 1, 1, 2, 2, 2, 3, 3, 3}}, 1, 1).rgb, testing::ElementsAre(2, 2, 2));
}

}  // namespace
}  // namespace pastoso::shade
