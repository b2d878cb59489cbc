#include "brush/laid_film.hpp"

#include "core/units.hpp"

#include <cmath>

#include <gtest/gtest.h>

namespace pastoso::brush {
namespace {

TEST(LaidFilm, OfAFullToolIsItsPresetsFilm) {
    EXPECT_DOUBLE_EQ(laid_film_mm(find_preset("flat"), 1.0), find_preset("flat").paint.film_mm);
    EXPECT_DOUBLE_EQ(laid_film_mm(find_preset("knife"), 1.0), find_preset("knife").paint.film_mm);
}

TEST(LaidFilm, OfABladeIsAnEighthOfItsWidthAtMost) {
    const Preset& knife = find_preset("knife");
    EXPECT_EQ(full_film_mm(knife), knife.paint.film_mm);
    EXPECT_EQ(full_film_mm(resized(knife, 40.0)), knife.paint.film_mm);
    EXPECT_DOUBLE_EQ(full_film_mm(resized(knife, 2.0)), 0.25);
    EXPECT_DOUBLE_EQ(laid_film_mm(resized(knife, 2.0), 1.0), 0.25);
    const Preset& flat = find_preset("flat");
    EXPECT_EQ(full_film_mm(resized(flat, 1.0)), flat.paint.film_mm);
}

TEST(LaidFilm, IsThinnerTheLessTheToolHolds) {
    const Preset flat = find_preset("flat");
    EXPECT_EQ(laid_film_mm(flat, 0.0), 0.0);
    // (1.22 * 0.3 / 0.52)^2
    EXPECT_NEAR(laid_film_mm(flat, 0.3), 0.495399 * flat.paint.film_mm, 1e-6);
    EXPECT_GT(laid_film_mm(flat, 1.2), flat.paint.film_mm);
}

TEST(LaidFilm, OfDropsSpreadsTheirVolumeOverTheirDisc) {
    Preset drops;
    drops.kind = ToolKind::Droplets;
    drops.droplets.drop_mm3 = 4.0;
    drops.droplets.steepness = 0.4;
    const double film_mm = laid_film_mm(drops, 1.0);
    const double radius_mm = film_mm / (0.5 * drops.droplets.steepness);
    EXPECT_NEAR(film_mm * core::kPi * radius_mm * radius_mm, drops.droplets.drop_mm3, 1e-12);
    EXPECT_EQ(laid_film_mm(drops, 0.1), film_mm);
}

TEST(LaidFilm, OfAirIsNone) {
    EXPECT_EQ(laid_film_mm(find_preset("blow"), 1.0), 0.0);
}

}  // namespace
}  // namespace pastoso::brush
