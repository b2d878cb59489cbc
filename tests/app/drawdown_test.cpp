#include "tools/drawdown.hpp"

#include "document/paint_mixing.hpp"
#include "pigment/lab.hpp"

#include <gtest/gtest.h>

namespace pastoso::tools {
namespace {

SwatchView oil_view() {
    SwatchView view;
    view.spot.film_mm = 0.22;
    view.medium = film::find_medium("heavy-body oil");
    return view;
}

double difference(const pigment::Srgb8& a, const pigment::Srgb8& b) {
    return ciede2000(pigment::lab(pigment::decoded(a)), pigment::lab(pigment::decoded(b)));
}

TEST(Drawdown, GoesFromTheFilmInHandToAThinOne) {
    const SwatchView view = oil_view();
    const Drawdown drawn = drawdown(tube_paint("PB29"), view);
    SwatchView over_black = view;
    over_black.spot.ground = {};
    EXPECT_EQ(drawn.over_black.front(), swatch_colour(tube_paint("PB29"), over_black));
    over_black.spot.film_mm *= pigment::kDrawnOut;
    EXPECT_EQ(drawn.over_black.back(), swatch_colour(tube_paint("PB29"), over_black));
}

TEST(Drawdown, ShowsTheBarBelowTransparentPaintAlone) {
    const auto contrast = [](const char* tube) {
        const Drawdown drawn = drawdown(tube_paint(tube), oil_view());
        return difference(drawn.over_white.back(), drawn.over_black.back());
    };
    EXPECT_LT(contrast("PR101"), 3.0);
    EXPECT_GT(contrast("PB29"), 25.0);
}

TEST(Drawdown, GradesThePaintInTheFilmAndMediumInHand) {
    SwatchView view = oil_view();
    EXPECT_EQ(drawdown(tube_paint("PR108"), view).hiding, pigment::Hiding::Opaque);
    EXPECT_EQ(hiding_of(tube_paint("PR108"), view), pigment::Hiding::Opaque);
    view.spot.film_mm = 0.04;
    EXPECT_EQ(hiding_of(tube_paint("PR108"), view), pigment::Hiding::Transparent);
    EXPECT_EQ(hiding_of(tube_paint(""), view), pigment::Hiding::Transparent);
    // Thinned to a tenth, ten times the film hides as much.
    view.spot.film_mm = 0.22;
    document::PaintRecipe thinned = tube_paint("PR108");
    thinned.strength = 0.1;
    EXPECT_EQ(hiding_of(thinned, view), pigment::Hiding::Transparent);
    view.spot.film_mm = 2.2;
    EXPECT_EQ(hiding_of(thinned, view), pigment::Hiding::Opaque);
}

}  // namespace
}  // namespace pastoso::tools
