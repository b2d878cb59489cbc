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

TEST(Thumbnail, ShowsWhatAToolDoesInWetPaint) {
    core::ThreadPool pool(1);
    brush::Preset rag = brush::find_preset("rag");
    const pigment::Image8 wiped = thumbnail(rag, kWidth_px, kHeight_px, pool);
    rag.exchange.pickup = 0.0;
    EXPECT_NE(wiped.rgb, thumbnail(rag, kWidth_px, kHeight_px, pool).rgb);
}

}  // namespace
}  // namespace pastoso::document
