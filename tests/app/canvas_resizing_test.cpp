#include "tools/canvas_resizing.hpp"

#include <gtest/gtest.h>

namespace pastoso::tools {
namespace {

document::CanvasSettings canvas(double width_mm = 60.0, double height_mm = 40.0) {
    document::CanvasSettings settings;
    settings.width_mm = width_mm;
    settings.height_mm = height_mm;
    settings.px_per_mm = 4.0;
    return settings;
}

TEST(CanvasResizing, TheAnchorDividesWhatIsNewOrCutOff) {
    EXPECT_EQ(anchored(canvas(), 80.0, 30.0, {0, 0}), (document::ResizeCanvas{0.0, 0.0, 80.0, 30.0}));
    EXPECT_EQ(anchored(canvas(), 80.0, 30.0, {1, 1}), (document::ResizeCanvas{-10.0, 5.0, 80.0, 30.0}));
    EXPECT_EQ(anchored(canvas(), 80.0, 30.0, {2, 2}), (document::ResizeCanvas{-20.0, 10.0, 80.0, 30.0}));
    EXPECT_EQ(anchored(canvas(), 60.0, 40.0, {2, 1}), (document::ResizeCanvas{0.0, 0.0, 60.0, 40.0}));
}

TEST(CanvasResizing, MarginsAreWholeCellsOnEverySide) {
    EXPECT_EQ(margins_of({-10.0, 5.0, 80.0, 30.0}, canvas()), (Margins{10.0, -5.0, 10.0, -5.0}));
    EXPECT_EQ(margins_of({0.0, 0.0, 60.0, 40.0}, canvas()), Margins{});
    // 10.1 mm are 40 cells and a bit; the nearest cell counts, and the far side makes up for it.
    EXPECT_EQ(margins_of({-10.1, 0.0, 80.0, 40.0}, canvas()), (Margins{10.0, 0.0, 10.0, 0.0}));
}

TEST(CanvasResizing, TheSelectionIsCroppedToItsCells) {
    const auto wanted = canvas();
    grid::Mask mask(document::canvas_shape(wanted));
    const auto selection = [&] { return std::make_shared<const grid::Mask>(mask); };
    EXPECT_EQ(cropped_to(nullptr, wanted), std::nullopt);
    EXPECT_EQ(cropped_to(selection(), wanted), std::nullopt);
    mask.set(20, 8, 1);
    mask.set(103, 51, 1);
    EXPECT_EQ(cropped_to(selection(), wanted), (document::ResizeCanvas{5.0, 2.0, 21.0, 11.0}));
    mask.set(0, 0, 1);
    mask.set(239, 159, 1);
    EXPECT_EQ(cropped_to(selection(), wanted), std::nullopt) << "it reaches over the whole canvas";
}

TEST(CanvasResizing, WhatLiesOnTheClothIsFurtherFromACornerThatMovedAway) {
    const document::CanvasSettings after = document::resized({-10.0, 5.0, 80.0, 30.0}, canvas());
    EXPECT_EQ(shift_mm(canvas(), after), glm::dvec2(10.0, -5.0));
    EXPECT_EQ(shift_mm(after, canvas()), glm::dvec2(-10.0, 5.0));
    document::CanvasSettings image = canvas();
    image.support = "image";
    EXPECT_EQ(shift_mm(image, document::resized({-10.0, 5.0, 80.0, 30.0}, image)),
              glm::dvec2(10.0, -5.0));
}

TEST(CanvasResizing, GuidesFollow) {
    Hand hand;
    hand.symmetry = {.centre_x_mm = 30.0, .centre_y_mm = 20.0, .axis_deg = 45.0, .mirror = true};
    hand.ruler = brush::Ruler{1.0, 2.0, 3.0, 4.0};
    hand.ellipse = brush::EllipseCurve{5.0, 6.0, 7.0, 8.0, 9.0};
    hand.guide.form = *hand.ruler;
    hand.air.fan_x_mm = 1.0;
    const Hand moved = moved_along(hand, {10.0, -5.0});
    EXPECT_EQ(
        moved.symmetry,
        (brush::Symmetry{.centre_x_mm = 40.0, .centre_y_mm = 15.0, .axis_deg = 45.0, .mirror = true}));
    EXPECT_EQ(moved.ruler, (brush::Ruler{11.0, -3.0, 13.0, -1.0}));
    EXPECT_EQ(moved.ellipse, (brush::EllipseCurve{15.0, 1.0, 7.0, 8.0, 9.0}));
    EXPECT_EQ(moved.guide.form, decltype(moved.guide.form)(brush::Ruler{11.0, -3.0, 13.0, -1.0}));
    EXPECT_EQ(moved.air.fan_x_mm, 11.0);
    EXPECT_EQ(moved_along(moved, {-10.0, 5.0}).ruler, hand.ruler);
    hand.guide.form = brush::StraightLine{};
    EXPECT_EQ(moved_along(hand, {10.0, -5.0}).guide, hand.guide) << "a straight line lies nowhere";
}

}  // namespace
}  // namespace pastoso::tools
