#include "layers/rotation.hpp"

#include <gtest/gtest.h>

namespace pastoso::layers {
namespace {

/// Red, green over blue, white; all opaque.
Tracing four_colours(const PicturePlace& place) {
    return {
        std::make_shared<const pigment::Picture>(pigment::Picture{2,
                                                                  2,
                                                                  {255, 0, 0, 255, 0, 255, 0, 255,  //
                                                                   0, 0, 255, 255, 255, 255, 255, 255}}),
        place, 0.7};
}

TEST(RotatedTracing, AQuarterTurnTakesEveryPixel) {
    const Tracing turned = rotated(four_colours({10, 0, 8, 8}), {90.0, {20, 10}, {10, 20}});
    ASSERT_EQ(turned.picture->width, 2);
    ASSERT_EQ(turned.picture->height, 2);
    const pigment::Picture wanted{2,
                                  2,
                                  {0, 0, 255, 255, 255, 0, 0, 255,  //
                                   255, 255, 255, 255, 0, 255, 0, 255}};
    EXPECT_EQ(*turned.picture, wanted);
    EXPECT_NEAR(turned.place.x_mm, 12.0, 1e-9);
    EXPECT_NEAR(turned.place.y_mm, 10.0, 1e-9);
    EXPECT_NEAR(turned.place.width_mm, 8.0, 1e-9);
    EXPECT_NEAR(turned.place.height_mm, 8.0, 1e-9);
    EXPECT_EQ(turned.opacity, 0.7);
}

TEST(RotatedTracing, ATiltedOneLiesOnTransparentGround) {
    const auto picture = std::make_shared<pigment::Picture>(pigment::Picture{40, 20, {}});
    picture->rgba.assign(std::size_t{4} * 40 * 20, 255);
    const Tracing turned = rotated({picture, {0, 0, 40, 20}, 1.0}, {30.0, {20, 10}, {50, 60}});
    const double wide = 40 * std::sqrt(0.75) + 20 * 0.5, high = 40 * 0.5 + 20 * std::sqrt(0.75);
    EXPECT_NEAR(turned.place.width_mm, wide, 1e-9);
    EXPECT_NEAR(turned.place.height_mm, high, 1e-9);
    EXPECT_NEAR(turned.place.x_mm + 0.5 * wide, 50.0, 1e-9);
    EXPECT_NEAR(turned.place.y_mm + 0.5 * high, 60.0, 1e-9);
    const auto coverage = [&](int x, int y) {
        return turned.picture->rgba[4 * (static_cast<std::size_t>(y) * turned.picture->width + x) + 3];
    };
    EXPECT_EQ(turned.picture->width, 44);
    EXPECT_EQ(turned.picture->height, 37);
    EXPECT_EQ(coverage(22, 18), 255);
    EXPECT_EQ(coverage(0, 0), 0);
    EXPECT_EQ(coverage(43, 36), 0);
    double covered = 0.0;
    for (int y = 0; y < turned.picture->height; ++y)
        for (int x = 0; x < turned.picture->width; ++x)
            covered += coverage(x, y) / 255.0;
    // Its pixels are a little larger, as whole ones have to fill the place.
    EXPECT_NEAR(covered * wide / 44 * high / 37, 800.0, 8.0);
}

}  // namespace
}  // namespace pastoso::layers
