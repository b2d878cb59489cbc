#include "tools/swatch.hpp"

#include "document/paint_mixing.hpp"
#include "pigment/lab.hpp"
#include "pigment/palette.hpp"

#include <gtest/gtest.h>

namespace pastoso::tools {
namespace {

SwatchView daylight_view() {
    SwatchView view;
    view.spot.ground.fill(0.93F);
    view.medium = film::find_medium("heavy-body oil");
    return view;
}

int brightness(const pigment::Srgb8& colour) {
    return colour[0] + colour[1] + colour[2];
}

TEST(Swatch, OfATubeIsTheSpotOfItsPaintInTheMediumInHand) {
    const SwatchView view = daylight_view();
    const document::PaintRecipe blue = tube_paint("PB29");
    EXPECT_EQ(swatch_colour(blue, view),
              shade::spot_colour(document::mixed_paint(blue, view.medium), view.spot));
}

TEST(Swatch, IsPaleWhereTheToolLaysAThinFilm) {
    SwatchView view = daylight_view();
    const int thick = brightness(swatch_colour(tube_paint("PB29"), view));
    view.spot.film_mm = 0.02;
    EXPECT_GT(brightness(swatch_colour(tube_paint("PB29"), view)), thick + 50);
}

TEST(Swatch, EveryTintIsAtLeastAsLightAsItsTube) {
    for (const pigment::Pigment& pigment : pigment::bundled_palette()) {
        const auto colour = [&](const document::PaintRecipe& paint) {
            return brightness(swatch_colour(paint, daylight_view()));
        };
        // Zinc white lets a little more of the white ground through than it has of its own.
        EXPECT_GE(colour(tube_tint(pigment.ci_name)) + 3, colour(tube_paint(pigment.ci_name)))
            << pigment.ci_name;
    }
}

TEST(Swatch, OfTheClearMediumIsTheGround) {
    SwatchView view = daylight_view();
    const pigment::Srgb8 over_white = swatch_colour(tube_paint(""), view);
    EXPECT_GT(brightness(over_white), 600);
    view.spot.ground.fill(0.05F);
    EXPECT_LT(brightness(swatch_colour(tube_paint(""), view)), 200);
}

TEST(WetColour, ThickWhiteHidesAllAndTheMediumNothing) {
    SwatchView view = daylight_view();
    view.spot.film_mm = 2.0;
    EXPECT_NEAR(wet_colour(tube_paint("PW6"), view).opacity, 1.0, 0.02);
    view.spot.film_mm = 0.0;
    // Black shines a little, and titanium white is no full white.
    EXPECT_NEAR(wet_colour(tube_paint(""), view).opacity, 0.1, 0.1);
}

TEST(WetColour, ADarkFilmHidesMoreThanAPaleOneOfItsPaint) {
    SwatchView view = daylight_view();
    double before = 0.0;
    for (const double film_mm : {0.01, 0.03, 0.1, 0.3}) {
        view.spot.film_mm = film_mm;
        const double opacity = wet_colour(tube_paint("PB29"), view).opacity;
        EXPECT_GT(opacity, before);
        before = opacity;
    }
    EXPECT_GT(before, 0.8);
}

TEST(WetColour, OfALoadIsTheMeanByHowFullItsStripesAre) {
    const SwatchView view = daylight_view();
    const film::PaintCoefficients blue = document::mixed_paint(tube_paint("PB29"), view.medium);
    brush::LoadProfile load;
    EXPECT_EQ(wet_colour(load, view), std::nullopt);
    load.fill = 0.5;
    load.stripes[3] = {0.25, blue};
    load.stripes[4] = {0.25, blue};
    EXPECT_EQ(wet_colour(load, view), wet_colour(blue, view));
    load.fill = 0.15;
    EXPECT_DOUBLE_EQ(wet_colour(load, view)->opacity, 0.5 * wet_colour(blue, view).opacity);
    load.fill = 0.5;
    load.stripes[9] = {0.5, document::mixed_paint(tube_paint("PW6"), view.medium)};
    EXPECT_GT(brightness(wet_colour(load, view)->colour),
              brightness(wet_colour(blue, view).colour) + 30);
}

TEST(FilmInHand, IsWhatTheToolLaysOrTheMediumsOwn) {
    Hand hand;
    EXPECT_DOUBLE_EQ(film_in_hand_mm(hand), preset_in_hand(hand).paint.film_mm);
    hand.dip.fill = 0.3;
    EXPECT_LT(film_in_hand_mm(hand), 0.6 * preset_in_hand(hand).paint.film_mm);
    hand.brush = brush::find_preset("rag").name;
    EXPECT_EQ(film_in_hand_mm(hand), film::find_medium(hand.medium.name).typical_thickness_mm);
    hand.brush = brush::find_preset("blow").name;
    EXPECT_EQ(film_in_hand_mm(hand), film::find_medium(hand.medium.name).typical_thickness_mm);
}

}  // namespace
}  // namespace pastoso::tools
