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

TEST(ColourModels, WhatLiesOutsideIsBroughtIn) {
    const Srgb8 colour = colour_from(ColourModel::Oklch, {60.0, 0.4, 150.0});
    EXPECT_GT(colour[1], colour[0]);
    EXPECT_GT(colour[1], colour[2]);
}

}  // namespace
}  // namespace pastoso::tools
