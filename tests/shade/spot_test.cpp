#include "shade/spot.hpp"

#include "canvas.hpp"
#include "core/error.hpp"
#include "film/medium.hpp"
#include "pigment/lab.hpp"
#include "pigment/palette.hpp"
#include "shade/varnish.hpp"

#include <vector>

#include <gtest/gtest.h>

namespace pastoso::shade {
namespace {

constexpr pigment::Bands kUmberGround = {0.05F, 0.07F, 0.10F, 0.16F, 0.22F, 0.25F};

film::PaintCoefficients oil(const pigment::Coefficients& pigment) {
    return film::paint_coefficients(pigment, film::find_medium("heavy-body oil"));
}

/// The middle of a level canvas with such a film all over, as pictures show it.
pigment::Srgb8 rendered(const pigment::Coefficients& paint, const Spot& spot) {
    constexpr int kSide = 24;
    film::FilmState film(grid::Shape{kSide, kSide}, 0.25);
    for (int y = 0; y < kSide; ++y)
        for (int x = 0; x < kSide; ++x)
            test::set_paint(film, x, y, spot.film_mm, paint);
    core::ThreadPool pool(1);
    const pigment::Image8 picture = encode_srgb8(
        render(film, spot.ground, film.shape.cells(), {1.0, spot.lighting, spot.viewing}, pool));
    const std::size_t middle = 3 * (kSide / 2 * kSide + kSide / 2);
    return {picture.rgb[middle], picture.rgb[middle + 1], picture.rgb[middle + 2]};
}

double difference(const pigment::Srgb8& a, const pigment::Srgb8& b) {
    return ciede2000(pigment::lab(pigment::decoded(a)), pigment::lab(pigment::decoded(b)));
}

std::vector<Spot> ways_to_look() {
    Lighting lamp;
    lamp.azimuth_deg = 20.0;
    lamp.elevation_deg = 70.0;
    lamp.ambient = 0.1;
    const auto incandescent = pigment::viewing_under(pigment::find_illuminant("A"));
    return {{0.22, test::kGround, {}, {}}, {0.22, test::kGround, lamp, incandescent},
            {0.22, kUmberGround, {}, {}},  {0.22, kUmberGround, lamp, incandescent},
            {0.01, test::kGround, {}, {}}, {3.0, kUmberGround, {}, {}}};
}

TEST(Spot, HasTheColourThatEveryPaintHasOnTheCanvas) {
    for (const Spot& spot : ways_to_look()) {
        for (const pigment::Pigment& paint : pigment::bundled_palette()) {
            const pigment::Srgb8 shown = spot_colour(oil(paint.coefficients), spot);
            // At most one level of 8 bits, where the two round to different sides.
            EXPECT_LT(difference(shown, rendered(paint.coefficients, spot)), 0.5)
                << paint.ci_name << " " << spot.film_mm << " mm";
        }
    }
}

TEST(Spot, IsSeenThroughTheVarnishToo) {
    const Varnish varnish{Finish::Gloss, 1.0, 0.7};
    const auto& white = pigment::find_pigment("PW6").coefficients;
    const Spot bare{0.22, test::kGround, {}, {}};
    const Spot coated{0.22, test::kGround, varnished(bare.lighting, varnish),
                      varnished(bare.viewing, varnish)};
    EXPECT_LT(difference(spot_colour(oil(white), coated), rendered(white, coated)), 0.5);
    EXPECT_GT(difference(spot_colour(oil(white), coated), spot_colour(oil(white), bare)), 5.0);
}

TEST(Spot, OfAThinFilmShowsTheGround) {
    const auto blue = oil(pigment::find_pigment("PB29").coefficients);
    const Spot thin{0.01, test::kGround, {}, {}}, thin_on_umber{0.01, kUmberGround, {}, {}};
    Spot thick = thin, thick_on_umber = thin_on_umber;
    thick.film_mm = thick_on_umber.film_mm = 3.0;
    EXPECT_GT(difference(spot_colour(blue, thin), spot_colour(blue, thin_on_umber)), 20.0);
    EXPECT_LT(difference(spot_colour(blue, thick), spot_colour(blue, thick_on_umber)), 0.5);
}

TEST(Spot, OfNoPaintIsTheBareGround) {
    const Spot bare{0.0, test::kGround, {}, {}};
    EXPECT_LT(difference(spot_colour({}, bare), rendered({}, bare)), 0.5);
}

TEST(Spot, RefusesALightThatThereIsNot) {
    Spot spot;
    spot.lighting.elevation_deg = 0.0;
    EXPECT_THROW(spot_colour({}, spot), core::InputError);
}

}  // namespace
}  // namespace pastoso::shade
