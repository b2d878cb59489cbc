// Reliefs of textures: exact where they are told exactly, the same one at every resolution.
#include "layers/texture/texture_relief.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include <gtest/gtest.h>

namespace pastoso::layers {
namespace {

constexpr grid::Rect kPiece{3, 5, 67, 69};

double mean_of(const CellHeights& heights) {
    return std::accumulate(heights.begin(), heights.end(), 0.0) / static_cast<double>(heights.size());
}

double deviation_of(const CellHeights& heights) {
    const double mean = mean_of(heights);
    double sum = 0.0;
    for (const float height : heights)
        sum += (height - mean) * (height - mean);
    return std::sqrt(sum / static_cast<double>(heights.size()));
}

/// The largest difference of cells and of the means of the four that are half as large.
double coarser_error(const Texture& texture, double cell_mm) {
    const CellHeights coarse = texture_heights(texture, kPiece, cell_mm);
    const CellHeights fine = texture_heights(
        texture, {2 * kPiece.x0, 2 * kPiece.y0, 2 * kPiece.x1, 2 * kPiece.y1}, 0.5 * cell_mm);
    const int columns = kPiece.width();
    double most = 0.0;
    for (int y = 0; y < kPiece.height(); ++y)
        for (int x = 0; x < columns; ++x) {
            const float* above = &fine[static_cast<std::size_t>(2 * y) * 2 * columns + 2 * x];
            const float* below = above + 2 * columns;
            const double mean = 0.25 * (above[0] + above[1] + below[0] + below[1]);
            most = std::max(most, std::abs(mean - coarse[static_cast<std::size_t>(y) * columns + x]));
        }
    return most;
}

PressedTexture pressed(int width, int height, std::vector<std::uint8_t> rgba) {
    auto picture = std::make_shared<pigment::Picture>(pigment::Picture{width, height, std::move(rgba)});
    return {.place = {0.0, 0.0, 0.25 * width, 0.25 * height}, .height_mm = 1.0, .picture = picture};
}

TEST(Texture, IsTheSameSandAtEveryResolution) {
    for (const double grain_mm : {0.3, 0.4, 0.7, 2.0})
        EXPECT_LT(coarser_error(SandTexture{grain_mm, 5}, 0.25), 0.08 * grain_mm) << grain_mm;
}

TEST(Texture, IsTheSamePasteAtEveryResolution) {
    for (const double spacing_mm : {0.5, 1.3, 4.0})
        EXPECT_LT(coarser_error(KnifedTexture{1.0, spacing_mm, 33.0, 5}, 0.25), 0.12) << spacing_mm;
}

TEST(Texture, AGrainStandsAsHighAsItIsThick) {
    const CellHeights heights = texture_heights(SandTexture{1.0, 2}, {0, 0, 400, 400}, 0.05);
    EXPECT_FLOAT_EQ(*std::min_element(heights.begin(), heights.end()), 0.2F) << "binder";
    const float highest = *std::max_element(heights.begin(), heights.end());
    EXPECT_GT(highest, 0.8F);
    EXPECT_LE(highest, 1.27F);
    EXPECT_GT(deviation_of(heights), 0.12);
}

TEST(Texture, GrainsFinerThanCellsAreTheirMeanThickness) {
    const CellHeights heights = texture_heights(SandTexture{0.1, 2}, kPiece, 1.0);
    EXPECT_EQ(deviation_of(heights), 0.0);
    const CellHeights sampled = texture_heights(SandTexture{1.0, 2}, {0, 0, 400, 400}, 0.1);
    EXPECT_NEAR(mean_of(heights), 0.1 * mean_of(sampled), 0.002);
}

TEST(Texture, GrainsGrowWithTheirDiameter) {
    const CellHeights fine = texture_heights(SandTexture{0.5, 9}, kPiece, 0.1);
    const CellHeights coarse = texture_heights(SandTexture{1.0, 9}, kPiece, 0.2);
    for (std::size_t i = 0; i < fine.size(); ++i)
        ASSERT_NEAR(2.0F * fine[i], coarse[i], 1e-4F);
}

TEST(Texture, APieceIsWhatTheWholeHasThere) {
    const std::vector<Texture> textures = {SandTexture{}, KnifedTexture{}};
    for (const Texture& texture : textures) {
        const CellHeights whole = texture_heights(texture, {0, 0, 100, 80}, 0.25);
        const CellHeights piece = texture_heights(texture, {64, 40, 100, 80}, 0.25);
        for (int y = 40; y < 80; ++y)
            for (int x = 64; x < 100; ++x)
                ASSERT_NEAR(piece[static_cast<std::size_t>(y - 40) * 36 + x - 64],
                            whole[static_cast<std::size_t>(y) * 100 + x], 1e-5F);
    }
}

TEST(Texture, PasteKeepsItsHeightAndItsDirection) {
    const KnifedTexture paste{2.0, 3.0, 0.0, 4};
    const int side = kPiece.width();
    const CellHeights level = texture_heights(paste, kPiece, 0.5);
    const auto [least, most] = std::minmax_element(level.begin(), level.end());
    EXPECT_GE(*least, 0.08F);
    EXPECT_LE(*most, 2.0F);
    const auto change = [&](const CellHeights& heights, int step) {
        double sum = 0.0;
        for (int y = 0; y + 1 < side; ++y)
            for (int x = 0; x + 1 < side; ++x) {
                const std::size_t cell = static_cast<std::size_t>(y) * side + x;
                sum += std::abs(heights[cell + step] - heights[cell]);
            }
        return sum;
    };
    EXPECT_GT(change(level, side), 2.0 * change(level, 1)) << "ridges lie along the passes";
    const CellHeights upright = texture_heights(KnifedTexture{2.0, 3.0, 90.0, 4}, kPiece, 0.5);
    EXPECT_GT(change(upright, 1), 2.0 * change(upright, side));
}

TEST(Texture, AnotherSeedIsAnotherRelief) {
    const auto differ = [](const Texture& a, const Texture& b) {
        return texture_heights(a, kPiece, 0.25) != texture_heights(b, kPiece, 0.25);
    };
    EXPECT_TRUE(differ(SandTexture{0.6, 1}, SandTexture{0.6, 2}));
    EXPECT_TRUE(differ(KnifedTexture{1.0, 3.0, 0.0, 1}, KnifedTexture{1.0, 3.0, 0.0, 2}));
    EXPECT_FALSE(differ(SandTexture{0.6, 7}, SandTexture{0.6, 7}));
}

TEST(Texture, APictureIsPressedInAsBrightAsItIs) {
    PressedTexture picture =
        pressed(4, 1, {0, 0, 0, 255, 255, 255, 255, 255, 51, 51, 51, 255, 255, 255, 255, 0});
    const CellHeights heights = texture_heights(picture, {0, 0, 5, 1}, 0.25);
    EXPECT_EQ(heights[0], 0.0F);
    EXPECT_FLOAT_EQ(heights[1], 1.0F);
    EXPECT_FLOAT_EQ(heights[2], 0.2F);
    EXPECT_EQ(heights[3], 0.0F) << "clear";
    EXPECT_EQ(heights[4], 0.0F) << "beside it";
    picture.dark_raised = true;
    const CellHeights dark = texture_heights(picture, {0, 0, 5, 1}, 0.25);
    EXPECT_FLOAT_EQ(dark[0], 1.0F);
    EXPECT_NEAR(dark[1], 0.0F, 1e-6F);
    EXPECT_FLOAT_EQ(dark[2], 0.8F);
    EXPECT_EQ(dark[3], 0.0F);
}

TEST(Texture, ACellHasTheMeanOfItsPixels) {
    const PressedTexture picture =
        pressed(2, 2, {255, 255, 255, 255, 0, 0, 0, 255, 0, 0, 0, 255, 51, 51, 51, 255});
    EXPECT_FLOAT_EQ(texture_heights(picture, {0, 0, 1, 1}, 0.5)[0], 0.3F);
    const PressedTexture white = pressed(1, 1, {255, 255, 255, 255});
    EXPECT_FLOAT_EQ(texture_heights(white, {0, 0, 1, 1}, 0.5)[0], 0.25F) << "it covers a quarter";
}

TEST(Texture, OnlyWhatIsChosenGetsAThickness) {
    core::ThreadPool pool(2);
    const grid::Shape shape{150, 70};
    grid::Mask mask(shape);
    mask.write(shape.tile_at(70, 3))[grid::Shape::cell_in_tile(70, 3)] = grid::kWhole;
    const auto all = texture_relief(SandTexture{}, shape, 0.25, nullptr, pool);
    const auto one = texture_relief(SandTexture{}, shape, 0.25, &mask, pool);
    for (int y = 0; y < 70; ++y)
        for (int x = 0; x < 150; ++x) {
            ASSERT_GT(all.at(x, y), 0);
            ASSERT_EQ(one.at(x, y), x == 70 && y == 3 ? all.at(x, y) : 0);
        }
}

}  // namespace
}  // namespace pastoso::layers
