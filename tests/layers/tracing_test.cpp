#include "layers/tracing.hpp"

#include "core/random.hpp"
#include "layers/flat_paint.hpp"
#include "layers/random_layer.hpp"
#include "pigment/appearance.hpp"
#include "pigment/layer_optics.hpp"

#include <gtest/gtest.h>

namespace pastoso::layers {
namespace {

using test::kCell_mm;
using test::kShape;
using test::random_layer;

constexpr PicturePlace kPlace{10.0, 2.0, 25.0, 14.0};  // cells 40 to 140, 8 to 64

pigment::Picture noise() {
    pigment::Picture picture{50, 40, {}};
    for (std::uint32_t i = 0; i < 4U * 50 * 40; ++i)
        picture.rgba.push_back(static_cast<std::uint8_t>(256.0F * core::uniform_noise(i, 3)));
    return picture;
}

PictureStrata strata(core::ThreadPool& pool, double opacity = 1.0) {
    return picture_strata(picture_cells(noise(), kPlace, kShape, kCell_mm, pool), opacity, pool);
}

/// What is seen of a band over a ground.
double seen_over(const film::StrataOptics& strata, int band, float ground) {
    return pigment::through_surface(pigment::reflectance_over(film::optics_of(strata, band), ground));
}

TEST(Tracing, HasTheColoursOfFlatPaintAndNothingElse) {
    core::ThreadPool pool(2);
    const PictureStrata picture = strata(pool);
    const film::FilmState paint = flat_paint(noise(), kPlace, kShape, kCell_mm, pool);
    int compared = 0;
    for (int y = 0; y < kShape.height; ++y)
        for (int x = 0; x < kShape.width; ++x) {
            // Flat paint leaves out what covers less than half a step of its relief.
            if (paint.support_mm.at(x, y) == 0.0F) continue;
            for (int band = 0; band < pigment::kBands; ++band)
                // Colours and coverage are kept in 65535ths, and so is what is made of them.
                ASSERT_NEAR(seen_over(picture.at(x, y), band, 0.4F),
                            seen_over(paint.strata.optics.at(x, y), band, 0.4F), 4.0 / 65535)
                    << x << ", " << y;
            ++compared;
        }
    EXPECT_GT(compared, 5500);  // of 5600
    EXPECT_EQ(picture.at(39, 30), film::kClearStrata);
    EXPECT_EQ(picture.at(140, 30), film::kClearStrata);
}

TEST(Tracing, FadesBetweenTheGroundAndThePicture) {
    core::ThreadPool pool(2);
    EXPECT_EQ(strata(pool, 0.0).at(100, 40), film::kClearStrata);
    const auto whole = strata(pool).at(100, 40), part = strata(pool, 0.3).at(100, 40);
    for (int band = 0; band < pigment::kBands; ++band)
        for (const float ground : {0.1F, 0.9F}) {
            const double bare = pigment::through_surface(ground);
            // Shares of light are kept in 65535ths, of a film and of its reverse.
            EXPECT_NEAR(seen_over(part, band, ground),
                        bare + 0.3 * (seen_over(whole, band, ground) - bare), 1e-4);
        }
}

TEST(Tracing, LiesBelowDryPaint) {
    core::ThreadPool pool(2);
    const PictureStrata picture = strata(pool);
    const film::FilmState paint = random_layer(7);
    TracedView view;
    const film::FilmState seen = view.of(paint, picture, pool);
    for (int y = 0; y < kShape.height; ++y)
        for (int x = 0; x < kShape.width; ++x)
            ASSERT_EQ(seen.strata.optics.at(x, y),
                      film::laid_over(paint.strata.optics.at(x, y), picture.at(x, y)))
                << x << ", " << y;
    for (int tile = 0; tile < kShape.tile_count(); ++tile) {
        EXPECT_TRUE(seen.thickness.shares_tile(paint.thickness, tile));
        EXPECT_TRUE(seen.support_mm.shares_tile(paint.support_mm, tile));
    }
    EXPECT_EQ(seen.strata.fixed, paint.strata.fixed);
}

TEST(Tracing, LooksAnewOnlyWhereSomethingChanged) {
    core::ThreadPool pool(2);
    const PictureStrata picture = strata(pool);
    film::FilmState paint = random_layer(7);
    TracedView view;
    const film::FilmState first = view.of(paint, picture, pool);
    paint.strata.optics.set(70, 20, film::StrataOptics{});
    const film::FilmState second = view.of(paint, picture, pool);
    const int changed = kShape.tile_at(70, 20);
    for (int tile = 0; tile < kShape.tile_count(); ++tile)
        EXPECT_EQ(second.strata.optics.shares_tile(first.strata.optics, tile), tile != changed);
    TracedView afresh;
    const film::FilmState again = afresh.of(paint, picture, pool);
    EXPECT_EQ(second.strata.optics.at(70, 20), again.strata.optics.at(70, 20));
    EXPECT_EQ(second.strata.optics.at(71, 20), again.strata.optics.at(71, 20));
}

TEST(Tracing, IsTheSameOnAnyNumberOfThreads) {
    core::ThreadPool one(1), three(3);
    const PictureStrata a = strata(one, 0.3), b = strata(three, 0.3);
    for (int y = 0; y < kShape.height; ++y)
        for (int x = 0; x < kShape.width; ++x)
            ASSERT_EQ(a.at(x, y), b.at(x, y));
}

}  // namespace
}  // namespace pastoso::layers
