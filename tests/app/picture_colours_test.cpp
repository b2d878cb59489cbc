#include "tools/picture_colours.hpp"

#include "core/random.hpp"
#include "tools/colour_models.hpp"

#include <cmath>
#include <cstdlib>

#include <gmock/gmock.h>

namespace pastoso::tools {
namespace {

using pigment::Srgb8;
using testing::ElementsAre;
using testing::IsEmpty;

/// A row of pixels.
pigment::Picture row_of(const std::vector<Srgb8>& colours, std::uint8_t alpha = 255) {
    pigment::Picture picture{static_cast<int>(colours.size()), 1, {}};
    for (const Srgb8& colour : colours)
        picture.rgba.insert(picture.rgba.end(), {colour[0], colour[1], colour[2], alpha});
    return picture;
}

/// 20 pixels about each of the colours, none farther than 6 levels.
pigment::Picture clouds(const std::vector<Srgb8>& middles) {
    std::vector<Srgb8> pixels;
    for (const Srgb8& middle : middles) {
        for (int i = 0; i < 20; ++i) {
            Srgb8 colour = middle;
            for (std::uint8_t& channel : colour) {
                const auto index = static_cast<std::uint32_t>(3 * pixels.size() + channel);
                const int away = static_cast<int>(13.0F * core::uniform_noise(index, 7)) - 6;
                channel = static_cast<std::uint8_t>(channel + away);
            }
            pixels.push_back(colour);
        }
    }
    return row_of(pixels);
}

TEST(PictureColours, AreThoseOfAPictureThatHasFew) {
    const pigment::Picture picture =
        row_of({{200, 30, 20}, {10, 10, 10}, {200, 30, 20}, {240, 240, 230}});
    EXPECT_THAT(picture_colours(picture, 3),
                ElementsAre(Srgb8{10, 10, 10}, Srgb8{200, 30, 20}, Srgb8{240, 240, 230}));
    EXPECT_THAT(picture_colours(picture, 9),
                ElementsAre(Srgb8{10, 10, 10}, Srgb8{200, 30, 20}, Srgb8{240, 240, 230}));
}

TEST(PictureColours, OneIsTheMeanByWeight) {
    pigment::Picture picture = row_of({{40, 40, 40}, {200, 200, 200}, {200, 200, 200}});
    const double lightness = (oklab({40, 40, 40})[0] + 2.0 * oklab({200, 200, 200})[0]) / 3.0;
    const Srgb8 mean = colour_of_oklab({lightness, 0.0, 0.0});
    const auto colours = picture_colours(picture, 1);
    ASSERT_EQ(colours.size(), 1U);
    for (std::size_t i = 0; i < 3; ++i)
        EXPECT_LE(std::abs(colours[0][i] - mean[i]), 1) << "greys of OKLab are rounded";
    picture.rgba[3] = 0;
    EXPECT_THAT(picture_colours(picture, 1), ElementsAre(Srgb8{200, 200, 200}));
}

TEST(PictureColours, NothingSeenGivesNone) {
    EXPECT_THAT(picture_colours({}, 5), IsEmpty());
    EXPECT_THAT(picture_colours(row_of({{1, 2, 3}}, 0), 5), IsEmpty());
}

TEST(PictureColours, FindCloudsOfColours) {
    const std::vector<Srgb8> middles = {{30, 40, 90}, {60, 120, 50}, {190, 60, 50}, {230, 210, 120}};
    const auto colours = picture_colours(clouds(middles), 4);
    ASSERT_EQ(colours.size(), 4U);
    for (std::size_t k = 0; k < 4; ++k)
        for (std::size_t i = 0; i < 3; ++i)
            EXPECT_NEAR(colours[k][i], middles[k][i], 6.0) << k << ": the mean of what is so far away";
}

TEST(PictureColours, AreTheSameEachTimeWhateverTheOrderOfPixels) {
    std::vector<Srgb8> pixels;
    for (std::uint32_t i = 0; i < 300; ++i)
        pixels.push_back({static_cast<std::uint8_t>(256.0F * core::uniform_noise(i, 1)),
                          static_cast<std::uint8_t>(256.0F * core::uniform_noise(i, 2)),
                          static_cast<std::uint8_t>(256.0F * core::uniform_noise(i, 3))});
    const auto colours = picture_colours(row_of(pixels), 8);
    EXPECT_EQ(colours.size(), 8U);
    const std::vector<Srgb8> backwards(pixels.rbegin(), pixels.rend());
    EXPECT_EQ(picture_colours(row_of(backwards), 8), colours);
}

TEST(PictureColours, AtAPlaceAreTheMeanOfLightAroundIt) {
    const pigment::Picture picture = row_of({{0, 0, 0}, {255, 255, 255}, {0, 0, 0}, {200, 30, 20}});
    EXPECT_EQ(mean_colour(picture, 1.9, 0.5, 0.1), (Srgb8{255, 255, 255}));
    EXPECT_EQ(mean_colour(picture, 3.5, 0.5, 0.5), (Srgb8{200, 30, 20}));
    EXPECT_EQ(mean_colour(picture, 1.0, 0.5, 1.0), (Srgb8{188, 188, 188})) << "half the light";
    EXPECT_EQ(mean_colour(picture, 0.1, 0.1, 0.5), (Srgb8{0, 0, 0})) << "at the edge";
}

TEST(PictureColours, AtAPlaceCountByTheirAlphaAndThereAreNoneBeside) {
    pigment::Picture picture = row_of({{0, 0, 0}, {90, 80, 70}});
    picture.rgba[3] = 0;
    EXPECT_EQ(mean_colour(picture, 1.0, 0.5, 1.0), (Srgb8{90, 80, 70}));
    EXPECT_EQ(mean_colour(picture, 0.5, 0.5, 0.4), std::nullopt);
    for (const double x_px : {-0.01, 2.0, 1e9})
        EXPECT_EQ(mean_colour(picture, x_px, 0.5, 1.0), std::nullopt);
}

TEST(PictureColours, AGreyIsAsLightAsItsColour) {
    EXPECT_EQ(grey_of({70, 70, 70}), (Srgb8{70, 70, 70}));
    EXPECT_EQ(grey_of({255, 0, 0}), (Srgb8{127, 127, 127})) << "0.2126 of the light";
    EXPECT_LT(grey_of({0, 0, 255})[0], grey_of({0, 255, 0})[0]);
}

}  // namespace
}  // namespace pastoso::tools
