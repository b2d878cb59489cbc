#include "layers/flat_paint.hpp"

#include "core/random.hpp"
#include "film/cell/paint_sample.hpp"
#include "layers/sums.hpp"
#include "pigment/appearance.hpp"
#include "pigment/hex_colour.hpp"
#include "pigment/lab.hpp"

#include <algorithm>

#include <gtest/gtest.h>

namespace pastoso::layers {
namespace {

constexpr grid::Shape kShape{100, 70};
constexpr double kCell_mm = 0.25;

pigment::Picture noise(int width, int height, bool opaque) {
    pigment::Picture picture{width, height, {}};
    for (std::uint32_t i = 0; i < 4U * width * height; ++i) {
        const auto value = static_cast<std::uint8_t>(256.0F * core::uniform_noise(i, 5));
        picture.rgba.push_back(opaque && i % 4 == 3 ? 255 : value);
    }
    return picture;
}

film::FilmState painted(const pigment::Picture& picture, int threads = 2) {
    core::ThreadPool pool(threads);
    return flat_paint(picture, {0.0, 0.0, picture.width * kCell_mm, picture.height * kCell_mm}, kShape,
                      kCell_mm, pool);
}

/// What is seen of a cell over a ground, before the surface.
pigment::LinearRgb seen(const film::FilmState& layer, int x, int y, float ground) {
    pigment::Bands bands{};
    for (int band = 0; band < pigment::kBands; ++band)
        bands[band] = pigment::through_surface(
            pigment::reflectance_over(film::optics_of(layer.strata.optics.at(x, y), band), ground));
    return pigment::linear_srgb(bands);
}

pigment::LinearRgb paint_of_pixel(const pigment::Picture& picture, int x, int y) {
    const std::uint8_t* pixel = &picture.rgba[std::size_t{4} * (y * picture.width + x)];
    return pigment::paint_colour(pigment::decoded({pixel[0], pixel[1], pixel[2]}));
}

TEST(FlatPaint, HasTheColoursOfThePicture) {
    const pigment::Picture picture = noise(80, 60, true);
    const film::FilmState layer = painted(picture);
    double largest = 0.0;
    for (int y = 0; y < picture.height; ++y)
        for (int x = 0; x < picture.width; ++x)
            largest = std::max(largest, pigment::ciede2000(pigment::lab(seen(layer, x, y, 0.5F)),
                                                           pigment::lab(paint_of_pixel(picture, x, y))));
    // Nearly black colours are off by up to 0.6 (pigment/rgb_bands.hpp).
    EXPECT_LT(largest, 0.6);
}

TEST(FlatPaint, CoversAsMuchOfTheLightAsThePictureSays) {
    const pigment::Picture picture = noise(40, 30, false);
    const film::FilmState layer = painted(picture);
    for (const float ground : {0.05F, 0.5F, 0.93F}) {
        const float below = pigment::through_surface(ground);
        for (int i = 0; i < 300; ++i) {
            const int x = i % 40, y = i % 29;
            const float share = static_cast<float>(picture.rgba[4 * (y * 40 + x) + 3]) / 255.0F;
            const pigment::LinearRgb paint = paint_of_pixel(picture, x, y);
            const pigment::LinearRgb cell = seen(layer, x, y, ground);
            for (int k = 0; k < 3; ++k)  // steps of the optics, and blacks as above
                EXPECT_NEAR(cell[k], share * paint[k] + (1.0F - share) * below, 2e-3F);
        }
    }
}

TEST(FlatPaint, LiesAsHighAsItCovers) {
    const pigment::Picture picture = noise(40, 30, false);
    const film::FilmState layer = painted(picture);
    for (int x = 0; x < 40; ++x) {
        const float share = static_cast<float>(picture.rgba[4 * x + 3]) / 255.0F;
        EXPECT_NEAR(layer.support_mm.at(x, 0), share * kFlatPaint_mm, film::kSupportQuantum_mm);
    }
    EXPECT_EQ(layer.support_mm.at(50, 0), 0.0F);
}

TEST(FlatPaint, IsCountedAsItsRelief) {
    const film::FilmState layer = painted(noise(80, 60, false));
    const test::Sums sums = test::sums_of(layer);
    EXPECT_EQ(sums.thickness * film::kThicknessQuantum_mm, sums.relief * film::kSupportQuantum_mm);
    EXPECT_GT(sums.thickness, 0);
    EXPECT_FALSE(film::has_wet_paint(layer));
}

TEST(FlatPaint, IsFoundByTheEyedropper) {
    const pigment::Picture picture = noise(40, 30, true);
    const film::FilmState layer = painted(picture);
    const film::PaintSample sample = film::sample_paint(layer, 5.125, 3.125, 0.0);
    EXPECT_EQ(sample.layer, film::PaintLayer::Dry);
    EXPECT_LT(pigment::ciede2000(pigment::lab(pigment::masstone(sample.coefficients)),
                                 pigment::lab(paint_of_pixel(picture, 20, 12))),
              1.5);  // mixtures are kept to 0.5 % of their square root
}

TEST(FlatPaint, OfWhiteIsTitaniumWhite) {
    pigment::Picture white{4, 4, std::vector<std::uint8_t>(64, 255)};
    const pigment::LinearRgb colour = seen(painted(white), 2, 2, 0.0F);
    for (const float channel : colour)
        EXPECT_NEAR(channel, pigment::kPaintWhite, 1e-3F);
}

TEST(FlatPaint, HoldsNothingWhereThePictureIsClear) {
    const pigment::Picture clear{100, 70, std::vector<std::uint8_t>(std::size_t{4} * 100 * 70, 0)};
    const film::FilmState layer = painted(clear);
    EXPECT_EQ(layer.strata.optics.allocated_bytes() + layer.support_mm.allocated_bytes(), 0U);
}

TEST(FlatPaint, IsTheSameOnAnyNumberOfThreads) {
    const pigment::Picture picture = noise(90, 65, false);
    EXPECT_EQ(film::state_hash(painted(picture, 1)), film::state_hash(painted(picture, 3)));
}

}  // namespace
}  // namespace pastoso::layers
