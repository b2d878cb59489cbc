#include "tools/paint_share.hpp"

#include "document/actions/actions.hpp"
#include "tools/swatch.hpp"

#include <gtest/gtest.h>

namespace pastoso::tools {
namespace {

Body body_at(double share) {
    return body_of(film::thinned(film::find_medium("heavy-body oil"), share));
}

TEST(PaintShare, OilFromTheTubeGoesFromPasteToStain) {
    EXPECT_EQ(body_at(1.0), Body::Paste);
    EXPECT_EQ(body_at(0.6), Body::Cream);
    EXPECT_EQ(body_at(0.3), Body::Milk);
    EXPECT_EQ(body_at(kWashShare), Body::Wash);
    EXPECT_EQ(body_at(film::kLeastPaintShare), Body::Stain);
}

TEST(PaintShare, AFluidPaintIsNoPasteFromTheTin) {
    EXPECT_EQ(body_of(film::find_medium("house paint")), Body::Cream);
    EXPECT_EQ(body_of(film::find_medium("ink glaze")), Body::Milk);
}

TEST(PaintShare, StepsByEqualFactorsFromEndToEnd) {
    double share = 1.0;
    int steps = 0;
    for (; share > film::kLeastPaintShare; ++steps) {
        const double next = stepped_paint_share(share, 1);
        if (next > film::kLeastPaintShare) {
            EXPECT_NEAR(next / share, 0.75, 0.03) << share;
        }
        share = next;
    }
    EXPECT_EQ(steps, 14);
    for (; share < 1.0; --steps)
        share = stepped_paint_share(share, -1);
    EXPECT_EQ(steps, 0);
    EXPECT_EQ(stepped_paint_share(1.0, -1), 1.0);
    EXPECT_EQ(stepped_paint_share(film::kLeastPaintShare, 1), film::kLeastPaintShare);
}

TEST(PaintShare, IsOfNoMediumThatNothingThins) {
    Hand hand;
    EXPECT_TRUE(can_thin(hand));
    hand.medium = {"thinner"};
    EXPECT_FALSE(can_thin(hand));
}

TEST(PaintShare, TheNumbersBeforeThinningAreThePaintersOwn) {
    Hand hand;
    film::Medium own = film::find_medium("house paint");
    own.viscosity_m2_s = 0.01;
    hand.medium = {"house paint", own, 0.3};
    EXPECT_EQ(unthinned_medium(hand), own);
    EXPECT_LT(document::medium_of(hand.medium).viscosity_m2_s, 0.01);
}

/// Over black, a stain of white is darker than white from the tube.
TEST(PaintShare, SwatchesShowTheThinnedPaint) {
    Hand hand;
    SwatchView view;
    view.spot.ground = {};
    view.spot.film_mm = 0.05;
    const auto green_of_white = [&](double share) {
        hand.medium.paint_share = share;
        view.medium = document::medium_of(hand.medium);
        return swatch_colour(tube_paint("PW6"), view)[1];
    };
    const int full = green_of_white(1.0), wash = green_of_white(kWashShare);
    EXPECT_LT(wash + 60, full);
    EXPECT_LT(green_of_white(film::kLeastPaintShare), wash);
}

}  // namespace
}  // namespace pastoso::tools
