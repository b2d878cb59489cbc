// Media hold pigment, or hardly any: how much of black and white below a stroke is still seen through
// it.
#include "brush/seen_colour.hpp"
#include "brush/studio.hpp"

#include <cmath>
#include <ostream>

#include <gtest/gtest.h>

namespace pastoso::brush {
namespace {

/// What thick dry paint of a pigment gives back.
pigment::Bands ground_of(const char* pigment) {
    constexpr double kOpaque_mm = 2.0;
    film::FilmState film = studio::smooth(2.0, 2.0);
    studio::cover(film, kOpaque_mm, studio::oil(pigment));
    return film::test::wet_over(film.paint.at(4, 4).data(), film::test::kWhiteGround);
}

/// The share of the difference in L* of white and black that is left below the middle of a stroke.
double contrast_left(const char* medium, const char* pigment, const char* preset, double pressure) {
    film::FilmState film = studio::smooth(60.0, 30.0);
    Brush brush(find_preset(preset), 10.0, 2);
    brush.load(studio::paint_in(pigment, medium), 1.0);
    studio::paint(brush, film, studio::line(6.0, 15.0, 54.0, 15.0, pressure, 90.0));
    const grid::Rect middle = studio::cells_of(film, 25.0, 13.5, 35.0, 16.5);
    const pigment::Bands white = ground_of("PW6"), black = ground_of("PBk9");
    const auto lightness = [](const pigment::Bands& ground) {
        return pigment::lab(studio::seen_rgb(ground)).lightness;
    };
    return (studio::seen_colour(film, middle, white).lightness -
            studio::seen_colour(film, middle, black).lightness) /
           (lightness(white) - lightness(black));
}

constexpr const char* kTransparent[] = {"PR83", "PB29", "PG7", "PBr7-BS", "PY83"};

TEST(Glaze, OfTransparentPigmentsKeepsHalfOfTheContrastBelow) {
    for (const char* medium : {"ink glaze", "alkyd gel"})
        for (const char* pigment : kTransparent)
            EXPECT_GE(contrast_left(medium, pigment, "Soft glazing flat 16", 0.25), 0.5)
                << medium << ", " << pigment;
}

TEST(Glaze, HeavyBodyOilHidesWhatIsBelow) {
    for (const char* pigment : kTransparent)
        EXPECT_LE(std::abs(contrast_left("heavy-body oil", pigment, "Impasto flat 18", 0.4)), 0.05)
            << pigment;
}

}  // namespace
}  // namespace pastoso::brush
