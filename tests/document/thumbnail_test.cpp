#include "document/thumbnail.hpp"

#include "core/thread_pool.hpp"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

namespace pastoso::document {
namespace {

constexpr int kWidth_px = 96, kHeight_px = 40;

/// Pixels that are far from the white of the board.
int painted_pixels(const pigment::Image8& image) {
    int count = 0;
    for (std::size_t i = 0; i + 2 < image.rgb.size(); i += 3) {
        const int least = std::min({image.rgb[i], image.rgb[i + 1], image.rgb[i + 2]});
        count += least < 160 ? 1 : 0;
    }
    return count;
}

class AnyPreset : public testing::TestWithParam<brush::Preset> {};

TEST_P(AnyPreset, LeavesItsMarkWithinTheFrame) {
    core::ThreadPool pool(1);
    const pigment::Image8 image = thumbnail(GetParam(), kWidth_px, kHeight_px, pool);
    EXPECT_EQ(image.width, kWidth_px);
    EXPECT_EQ(image.height, kHeight_px);
    EXPECT_GT(painted_pixels(image), 30);
    EXPECT_LT(painted_pixels(image), kWidth_px * kHeight_px);
}
INSTANTIATE_TEST_SUITE_P(Presets, AnyPreset, testing::ValuesIn(brush::bundled_presets()),
                         [](const auto& test) {
                             std::string name = test.param.name;
                             std::erase_if(name, [](char c) { return std::isalnum(c) == 0; });
                             return name;
                         });

TEST(Thumbnail, IsTheSameEveryTimeAndOnAnyThreads) {
    core::ThreadPool one(1), three(3);
    const brush::Preset& preset = brush::find_preset("spray");
    EXPECT_EQ(thumbnail(preset, kWidth_px, kHeight_px, one).rgb,
              thumbnail(preset, kWidth_px, kHeight_px, three).rgb);
}

TEST(Thumbnail, ShowsTheWidestToolsToo) {
    core::ThreadPool pool(1);
    for (const char* name : {"squeegee", "flat", "Marbling comb 80"}) {
        const brush::Preset wide = brush::resized(brush::find_preset(name), 200.0);
        EXPECT_GT(painted_pixels(thumbnail(wide, kWidth_px, kHeight_px, pool)), 100) << name;
    }
}

TEST(Thumbnail, ShowsWhatAToolDoesInWetPaint) {
    core::ThreadPool pool(1);
    brush::Preset rag = brush::find_preset("rag");
    const pigment::Image8 wiped = thumbnail(rag, kWidth_px, kHeight_px, pool);
    rag.exchange.pickup = 0.0;
    EXPECT_NE(wiped.rgb, thumbnail(rag, kWidth_px, kHeight_px, pool).rgb);
}

struct Rgb {
    int red, green, blue;
};

/// Of a place in shares of the picture.
Rgb colour_at(const pigment::Image8& image, double x, double y) {
    const int column = static_cast<int>(x * image.width), row = static_cast<int>(y * image.height);
    const auto* pixel = image.rgb.data() + 3 * (row * image.width + column);
    return {pixel[0], pixel[1], pixel[2]};
}

pigment::Image8 swatch(const char* medium) {
    core::ThreadPool pool(1);
    return thumbnail(film::find_medium(medium), 96, 60, pool);
}

TEST(MediumThumbnail, OilHidesBlackAndAGlazeLetsItThrough) {
    const pigment::Image8 oil = swatch("heavy-body oil"), glaze = swatch("ink glaze");
    EXPECT_GT(colour_at(oil, 0.7, 0.32).red, 120);
    EXPECT_LT(colour_at(glaze, 0.7, 0.32).red, 100);
    EXPECT_LT(colour_at(oil, 0.75, 0.9).red, 60) << "the ground there";
    EXPECT_GT(colour_at(oil, 0.25, 0.9).red, 200);
}

TEST(MediumThumbnail, HousePaintRunsAndOilStands) {
    const auto reddest_below = [](const char* medium) {
        const pigment::Image8 image = swatch(medium);
        int lowest = 0;
        for (int row = 0; row < image.height; ++row)
            for (double x = 0.15; x < 0.45; x += 0.02) {
                const Rgb rgb = colour_at(image, x, (row + 0.5) / image.height);
                if (rgb.red > 2 * rgb.green) lowest = row;
            }
        return lowest;
    };
    EXPECT_GT(reddest_below("house paint"), reddest_below("heavy-body oil") + 3);
}

TEST(MediumThumbnail, ThinnerTakesTheOilThatItFallsOnDownAndClearsIt) {
    const pigment::Image8 thinner = swatch("thinner"), oil = swatch("linseed oil");
    const auto is_red = [](const pigment::Image8& image, double x, double y) {
        const Rgb rgb = colour_at(image, x, y);
        return rgb.red > 2 * rgb.green;
    };
    EXPECT_TRUE(is_red(thinner, 0.25, 0.25)) << "the oil's stroke";
    EXPECT_TRUE(is_red(thinner, 0.3, 0.8));
    EXPECT_FALSE(is_red(oil, 0.3, 0.8)) << "it stands without thinner";
    EXPECT_LT(colour_at(thinner, 0.7, 0.7).red, 0.8 * colour_at(oil, 0.7, 0.35).red)
        << "more of the black is seen";
}

}  // namespace
}  // namespace pastoso::document
