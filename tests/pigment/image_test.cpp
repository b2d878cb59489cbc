#include "pigment/image.hpp"

#include "pigment/colour.hpp"

#include <cmath>

#include <gtest/gtest.h>

namespace pastoso::pigment {
namespace {

TEST(EncodeSrgb8, RoundsToTheNearestLevel) {
    LinearImage image{2048, 1, {}};
    for (int i = 0; i < 2048; ++i)
        image.rgb.insert(image.rgb.end(), 3, static_cast<float>(i) / 2047.0F);
    const Image8 encoded = encode_srgb8(image);
    EXPECT_EQ(encoded.width, 2048);
    for (int i = 0; i < 2048; ++i) {
        const double exact = 255.0 * encode_srgb(image.rgb[3 * i]);
        EXPECT_LE(std::abs(encoded.rgb[3 * i] - exact), 0.5001) << i;
        EXPECT_EQ(encoded.rgb[3 * i], encoded.rgb[3 * i + 2]);
    }
    EXPECT_EQ(encoded.rgb.front(), 0);
    EXPECT_EQ(encoded.rgb.back(), 255);
}

TEST(EncodeSrgb16, RoundsToTheNearestLevel) {
    constexpr int kWidth = 1 << 17;
    LinearImage image{kWidth, 1, {}};
    for (int i = 0; i < kWidth; ++i)
        image.rgb.insert(image.rgb.end(), 3, static_cast<float>(i) / (kWidth - 1));
    const Image16 encoded = encode_srgb16(image);
    for (int i = 0; i < kWidth; ++i) {
        const double exact = 65535.0 * encode_srgb(image.rgb[3 * i]);
        // The borders between levels are rounded to single precision: 2e-3 levels where they are widest.
        ASSERT_LE(std::abs(encoded.rgb[3 * i] - exact), 0.502) << i;
    }
    EXPECT_EQ(encoded.rgb.front(), 0);
    EXPECT_EQ(encoded.rgb.back(), 65535);
}

TEST(EncodeSrgb8, MapsIntoTheGamutOfThePicturesOwnSpace) {
    const LinearRgb colour = {1.3F, 0.4F, -0.2F};
    LinearImage image{1, 1, {colour[0], colour[1], colour[2]}, WorkingSpace::DisplayP3};
    const Image8 encoded = encode_srgb8(image);
    EXPECT_EQ(encoded.space, WorkingSpace::DisplayP3);
    EXPECT_EQ(encode_srgb16(image).space, WorkingSpace::DisplayP3);
    const LinearRgb mapped = into_gamut(colour, WorkingSpace::DisplayP3);
    for (int channel = 0; channel < 3; ++channel) {
        EXPECT_EQ(encoded.rgb[channel], std::lround(255.0 * encode_srgb(mapped[channel])));
    }
}

TEST(EncodeSrgb8, BringsColoursIntoTheGamut) {
    const LinearRgb colour = {1.3F, 0.4F, -0.2F};
    const Image8 encoded = encode_srgb8({1, 1, {colour[0], colour[1], colour[2]}});
    const LinearRgb mapped = into_gamut(colour);
    for (int channel = 0; channel < 3; ++channel) {
        EXPECT_EQ(encoded.rgb[channel], std::lround(255.0 * encode_srgb(mapped[channel])));
    }
}

}  // namespace
}  // namespace pastoso::pigment
