#include "layers/picture_means.hpp"

#include "core/random.hpp"
#include "pigment/colour.hpp"

#include <array>
#include <cmath>
#include <numeric>

#include <gtest/gtest.h>

namespace pastoso::layers {
namespace {

using Rgba = std::array<std::uint8_t, 4>;

pigment::Picture picture_of(int width, int height, const std::vector<Rgba>& pixels) {
    pigment::Picture picture{width, height, {}};
    for (const Rgba& pixel : pixels)
        picture.rgba.insert(picture.rgba.end(), pixel.begin(), pixel.end());
    return picture;
}

pigment::Picture noise(int width, int height) {
    pigment::Picture picture{width, height, {}};
    for (std::uint32_t i = 0; i < 4U * width * height; ++i)
        picture.rgba.push_back(static_cast<std::uint8_t>(256.0F * core::uniform_noise(i, 5)));
    return picture;
}

float linear(int level) {
    return static_cast<float>(pigment::decode_srgb(level / 255.0));
}

constexpr Rgba kRed = {255, 0, 0, 255}, kWhite = {255, 255, 255, 255}, kNone = {0, 0, 0, 0};

TEST(PictureMeans, OfOnePixelACellAreThePixels) {
    const pigment::Picture picture = noise(5, 4);
    const PictureMeans means(picture, {0.5, 0.25, 1.25, 1.0}, 0.25, {20, 10});
    EXPECT_EQ(means.cells(), (grid::Rect{2, 1, 7, 5}));
    for (int y = 0; y < 4; ++y)
        for (int x = 0; x < 5; ++x) {
            const CoveredColour cell = means.at(x + 2, y + 1);
            const std::uint8_t* pixel = &picture.rgba[4 * (y * 5 + x)];
            EXPECT_FLOAT_EQ(cell.coverage, pixel[3] / 255.0F);
            if (pixel[3] == 0) continue;
            for (int k = 0; k < 3; ++k)
                EXPECT_FLOAT_EQ(cell.colour[k], linear(pixel[k]));
        }
}

TEST(PictureMeans, AreOfLightAndLeaveOutWhatCoversNothing) {
    const pigment::Picture picture = picture_of(2, 2, {kRed, kWhite, kNone, kNone});
    const CoveredColour cell = PictureMeans(picture, {0, 0, 1, 1}, 1.0, {3, 3}).at(0, 0);
    EXPECT_FLOAT_EQ(cell.coverage, 0.5F);
    EXPECT_FLOAT_EQ(cell.colour[0], 1.0F);
    EXPECT_FLOAT_EQ(cell.colour[1], 0.5F);
    EXPECT_FLOAT_EQ(cell.colour[2], 0.5F);
}

TEST(PictureMeans, OfACellAtTheEdgeCoverItsShare) {
    const pigment::Picture picture = picture_of(1, 1, {kRed});
    const PictureMeans means(picture, {0.75, 0.5, 1.5, 2.0}, 1.0, {4, 4});
    EXPECT_EQ(means.cells(), (grid::Rect{0, 0, 3, 3}));
    EXPECT_FLOAT_EQ(means.at(0, 0).coverage, 0.25F * 0.5F);
    EXPECT_FLOAT_EQ(means.at(1, 1).coverage, 1.0F);
    EXPECT_FLOAT_EQ(means.at(2, 2).coverage, 0.25F * 0.5F);
    EXPECT_FLOAT_EQ(means.at(0, 0).colour[0], 1.0F);
}

TEST(PictureMeans, OfAnEnlargementRunFromPixelToPixel) {
    const pigment::Picture picture = picture_of(2, 1, {kNone, kWhite});
    const PictureMeans means(picture, {0, 0, 8, 4}, 1.0, {8, 4});
    // Pixels are 4 cells wide: clear up to the middle of the first, then evenly up to that of the other.
    const float expected[] = {0.0F, 0.0F, 0.125F, 0.375F, 0.625F, 0.875F, 1.0F, 1.0F};
    for (int x = 0; x < 8; ++x)
        EXPECT_NEAR(means.at(x, 2).coverage, expected[x], 1e-6F) << x;
}

TEST(PictureMeans, KeepTheSumOfWhatCovers) {
    const pigment::Picture picture = noise(37, 23);
    const double pixels = std::accumulate(picture.rgba.begin(), picture.rgba.end(), 0.0,
                                          [i = 0](double sum, std::uint8_t value) mutable {
                                              return ++i % 4 == 0 ? sum + value / 255.0 : sum;
                                          });
    const PictureMeans means(picture, {0.7, 0.4, 9.1, 5.3}, 1.0, {20, 10});
    double cells = 0.0;
    for (int y = means.cells().y0; y < means.cells().y1; ++y)
        for (int x = means.cells().x0; x < means.cells().x1; ++x)
            cells += means.at(x, y).coverage;
    // Cells at the edge have the mean of a whole cell's length: a few of them deviate a little.
    EXPECT_NEAR(cells / (9.1 * 5.3), pixels / (37 * 23), 0.01);
}

TEST(PictureMeans, BesideTheCanvasAreNone) {
    const pigment::Picture picture = picture_of(1, 1, {kRed});
    EXPECT_TRUE(PictureMeans(picture, {-5, 0, 4, 4}, 1.0, {3, 3}).cells().empty());
    EXPECT_TRUE(PictureMeans(picture, {9, 0, 4, 4}, 1.0, {3, 3}).cells().empty());
}

TEST(ReducedPicture, HasTheMeansOfItsPixels) {
    const pigment::Picture small = reduced(picture_of(2, 2, {kWhite, kWhite, kNone, kNone}), 1, 1);
    EXPECT_EQ(small, picture_of(1, 1, {{255, 255, 255, 128}}));
}

TEST(ReducedPicture, IsThePictureItselfWhereItIsSmallEnough) {
    EXPECT_EQ(reduced(noise(6, 5), 6, 5), noise(6, 5));
}

TEST(ReducedPicture, IsReducedAlongOneAxisAlone) {
    const pigment::Picture small = reduced(picture_of(2, 2, {kRed, kRed, kWhite, kWhite}), 1, 5);
    EXPECT_EQ(small, picture_of(1, 2, {kRed, kWhite}));
}

}  // namespace
}  // namespace pastoso::layers
