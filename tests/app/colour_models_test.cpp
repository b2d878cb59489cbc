#include "tools/colour_models.hpp"

#include <cstdlib>

#include <gtest/gtest.h>

namespace pastoso::tools {
namespace {

using pigment::Srgb8;

TEST(ColourModels, EveryColourComesBack) {
    for (const ColourModel model : {ColourModel::Rgb, ColourModel::Hsv, ColourModel::Oklch}) {
        for (int r = 0; r < 256; r += 51) {
            for (int g = 0; g < 256; g += 51) {
                for (int b = 0; b < 256; b += 51) {
                    const Srgb8 colour = {static_cast<std::uint8_t>(r), static_cast<std::uint8_t>(g),
                                          static_cast<std::uint8_t>(b)};
                    const Srgb8 back = colour_from(model, channels_from(model, colour));
                    for (int k = 0; k < 3; ++k)
                        EXPECT_EQ(back[k], colour[k]) << pigment::hex_colour(colour);
                }
            }
        }
    }
}

TEST(ColourModels, HsvHasItsCorners) {
    EXPECT_EQ(channels_from(ColourModel::Hsv, {255, 0, 0}), (Channels{0.0, 100.0, 100.0}));
    EXPECT_EQ(channels_from(ColourModel::Hsv, {0, 255, 0}), (Channels{120.0, 100.0, 100.0}));
    EXPECT_EQ(channels_from(ColourModel::Hsv, {0, 0, 255}), (Channels{240.0, 100.0, 100.0}));
    EXPECT_EQ(colour_from(ColourModel::Hsv, {360.0, 100.0, 100.0}), (Srgb8{255, 0, 0}));
}

TEST(ColourModels, OklchIsAsPublished) {
    // Ottosson's own values for the primaries, to the digits that he gives.
    const Channels white = channels_from(ColourModel::Oklch, {255, 255, 255});
    EXPECT_NEAR(white[0], 100.0, 0.01);
    EXPECT_EQ(white[1], 0.0);
    const Channels red = channels_from(ColourModel::Oklch, {255, 0, 0});
    EXPECT_NEAR(red[0], 62.8, 0.05);
    EXPECT_NEAR(red[1], 0.2577, 0.0005);
    EXPECT_NEAR(red[2], 29.2, 0.1);
}

TEST(ColourModels, OklabGoesThereAndBack) {
    const Channels red = oklab({255, 0, 0});
    EXPECT_NEAR(red[0], 0.628, 5e-4);
    EXPECT_NEAR(red[1], 0.2249, 5e-4);
    EXPECT_NEAR(red[2], 0.1258, 5e-4);
    EXPECT_EQ(colour_of_oklab(red), (Srgb8{255, 0, 0}));
    EXPECT_EQ(colour_of_oklab(oklab({12, 200, 99})), (Srgb8{12, 200, 99}));
}

TEST(ColourModels, AnglesAreTurnedToTheFirstRound) {
    EXPECT_EQ(turned_deg(-30.0), 330.0);
    EXPECT_EQ(turned_deg(720.0), 0.0);
    EXPECT_EQ(turned_deg(12.5), 12.5);
}

TEST(ColourModels, WhatLiesOutsideIsBroughtIn) {
    const Srgb8 colour = colour_from(ColourModel::Oklch, {60.0, 0.4, 150.0});
    EXPECT_GT(colour[1], colour[0]);
    EXPECT_GT(colour[1], colour[2]);
}

TEST(MostChroma, EndsWhereSrgbEnds) {
    // Ottosson's red, a corner of sRGB.
    const Channels red = channels_from(ColourModel::Oklch, {255, 0, 0});
    EXPECT_NEAR(most_chroma(red[0], red[2]), red[1], 5e-4);
    EXPECT_EQ(most_chroma(0.0, 30.0), 0.0);
    EXPECT_LT(most_chroma(100.0, 30.0), 5e-4);
    for (double hue_deg = 0.0; hue_deg < 360.0; hue_deg += 15.0) {
        const double most = most_chroma(65.0, hue_deg);
        EXPECT_TRUE(in_srgb({65.0, most, hue_deg})) << hue_deg;
        EXPECT_FALSE(in_srgb({65.0, most + 2e-3, hue_deg})) << hue_deg;
    }
}

}  // namespace
}  // namespace pastoso::tools
