#include "brush/load_profile.hpp"

#include "brush/brush.hpp"

#include <gtest/gtest.h>

namespace pastoso::brush {
namespace {

constexpr int kLast = LoadProfile::kStripes - 1;

film::PaintCoefficients paint_of(float coefficient) {
    film::PaintCoefficients paint{};
    paint[0] = coefficient;
    return paint;
}

TEST(LoadProfile, IsEmptyForACleanBrush) {
    EXPECT_EQ(load_profile(Brush(find_preset("flat"))), LoadProfile{});
}

TEST(LoadProfile, ShowsTheMeanPaintOfEveryStripe) {
    Brush brush(find_preset("flat"));
    const Contents taken = brush.load(paint_of(8.0F), 0.5);
    const LoadProfile profile = load_profile(brush);
    for (const auto& stripe : profile.stripes) {
        EXPECT_FLOAT_EQ(stripe.paint[0], 8.0F);
        // Only the overflow's limit on the stoutest hairs, 8 % of what they take, spoils the half.
        EXPECT_NEAR(stripe.fill, 0.5, 0.05);
    }
    Brush full(find_preset("flat"));
    const Contents most = full.load(paint_of(8.0F), 1.0);
    EXPECT_NEAR(profile.fill, taken.volume_mm3 / most.volume_mm3, 1e-12);
    EXPECT_NEAR(load_profile(full).fill, 1.0, 1e-12);
}

TEST(LoadProfile, KeepsTheTwoSidesOfADoubleLoadApart) {
    Brush brush(find_preset("flat"));
    brush.load({.first = paint_of(1.0F), .second = paint_of(3.0F), .side_by_side = true}, 1.0);
    const LoadProfile profile = load_profile(brush);
    EXPECT_FLOAT_EQ(profile.stripes[0].paint[0], 1.0F);
    EXPECT_FLOAT_EQ(profile.stripes[kLast].paint[0], 3.0F);
}

TEST(LoadProfile, ABottleIsTheSameAllAcross) {
    Brush bottle(find_preset("dropper"));
    bottle.load(paint_of(2.0F), 1.0);
    const LoadProfile profile = load_profile(bottle);
    ASSERT_GT(profile.fill, 0.0);
    EXPECT_EQ(profile.stripes[0], profile.stripes[kLast]);
}

TEST(BlottedBrush, KeepsItsPaintAndGivesUpItsShare) {
    Brush brush(find_preset("flat"));
    const Contents taken = brush.load(paint_of(8.0F), 1.0);
    const Contents blotted = brush.clean(0.75);
    // Sums of 300 bristles, in another order.
    EXPECT_NEAR(blotted.volume_mm3, 0.75 * taken.volume_mm3, 1e-12 * taken.volume_mm3);
    Contents sum = brush.contents();
    sum += blotted;
    EXPECT_NEAR(sum.paint[0], taken.paint[0], 1e-12 * taken.paint[0]);
    brush.clean();
    EXPECT_EQ(brush.contents(), Contents{});
}

}  // namespace
}  // namespace pastoso::brush
