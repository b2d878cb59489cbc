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
    EXPECT_EQ(move_between(canvas(), after), (CanvasMove{{}, {10.0, -5.0}}));
    EXPECT_EQ(move_between(after, canvas()), (CanvasMove{{}, {-10.0, 5.0}}));
    EXPECT_EQ(shift_of_middle_mm(canvas(), move_between(canvas(), after)), glm::dvec2(10.0, -5.0));
    document::CanvasSettings image = canvas();
    image.support = "image";
    EXPECT_EQ(move_between(image, document::resized({-10.0, 5.0, 80.0, 30.0}, image)),
              (CanvasMove{{}, {10.0, -5.0}}));
}

TEST(CanvasResizing, WhatLiesOnATurnedCanvasTurnsWithIt) {
    const core::Orientation right{false, 1}, mirror{true, 0};
    const document::CanvasSettings cut = document::resized({10.0, 5.0, 40.0, 30.0}, canvas());
    const document::CanvasSettings turned = document::turned(right, cut);
    const CanvasMove move = move_between(cut, turned);
    EXPECT_EQ(move(glm::dvec2(0.0, 0.0)), glm::dvec2(30.0, 0.0));
    EXPECT_EQ(move(glm::dvec2(7.0, 2.0)), glm::dvec2(28.0, 7.0));
    EXPECT_EQ(shift_of_middle_mm(cut, move), glm::dvec2(-5.0, 5.0));
    EXPECT_EQ(move_between(turned, cut)(glm::dvec2(28.0, 7.0)), glm::dvec2(7.0, 2.0)) << "undone";
    const CanvasMove both = move_between(canvas(), document::turned(mirror, turned));
    EXPECT_EQ(both(glm::dvec2(17.0, 7.0)), glm::dvec2(2.0, 7.0)) << "cut, turned and mirrored";
    const CanvasMove flip = move_between(canvas(), document::turned(mirror, canvas()));
    EXPECT_EQ(flip(glm::dvec2(1.0, 2.0)), glm::dvec2(59.0, 2.0));
    EXPECT_EQ(shift_of_middle_mm(canvas(), flip), glm::dvec2(0.0, 0.0));
}

TEST(CanvasResizing, GuidesTurn) {
    Hand hand;
    hand.symmetry = {.centre_x_mm = 30.0, .centre_y_mm = 20.0, .axis_deg = 30.0, .mirror = true};
    hand.ruler = brush::Ruler{1.0, 2.0, 3.0, 4.0};
    hand.ellipse = brush::EllipseCurve{5.0, 6.0, 7.0, 8.0, 9.0};
    hand.air.fan_x_mm = 1.0;
    const CanvasMove mirror{{true, 0}, {60.0, 0.0}}, right{{false, 1}, {40.0, 0.0}};
    const Hand mirrored = moved_along(hand, mirror), turned = moved_along(hand, right);
    EXPECT_EQ(mirrored.ruler, (brush::Ruler{59.0, 2.0, 57.0, 4.0}));
    EXPECT_EQ(mirrored.ellipse, (brush::EllipseCurve{55.0, 6.0, 7.0, 8.0, -9.0}));
    EXPECT_EQ(mirrored.symmetry.axis_deg, -30.0);
    EXPECT_EQ(mirrored.air.fan_x_mm, 59.0);
    EXPECT_EQ(turned.ruler, (brush::Ruler{38.0, 1.0, 36.0, 3.0}));
    EXPECT_EQ(turned.ellipse, (brush::EllipseCurve{34.0, 5.0, 7.0, 8.0, 99.0}));
    EXPECT_EQ(turned.symmetry.axis_deg, 120.0);
    EXPECT_EQ(moved_along(mirrored, mirror).ellipse, hand.ellipse);
}

TEST(CanvasResizing, GuidesFollow) {
    Hand hand;
    hand.symmetry = {.centre_x_mm = 30.0, .centre_y_mm = 20.0, .axis_deg = 45.0, .mirror = true};
    hand.ruler = brush::Ruler{1.0, 2.0, 3.0, 4.0};
    hand.ellipse = brush::EllipseCurve{5.0, 6.0, 7.0, 8.0, 9.0};
    hand.guide.form = *hand.ruler;
    hand.air.fan_x_mm = 1.0;
    const Hand moved = moved_along(hand, {{}, {10.0, -5.0}});
    EXPECT_EQ(
        moved.symmetry,
        (brush::Symmetry{.centre_x_mm = 40.0, .centre_y_mm = 15.0, .axis_deg = 45.0, .mirror = true}));
    EXPECT_EQ(moved.ruler, (brush::Ruler{11.0, -3.0, 13.0, -1.0}));
    EXPECT_EQ(moved.ellipse, (brush::EllipseCurve{15.0, 1.0, 7.0, 8.0, 9.0}));
    EXPECT_EQ(moved.guide.form, decltype(moved.guide.form)(brush::Ruler{11.0, -3.0, 13.0, -1.0}));
    EXPECT_EQ(moved.air.fan_x_mm, 11.0);
    EXPECT_EQ(moved_along(moved, {{}, {-10.0, 5.0}}).ruler, hand.ruler);
    hand.guide.form = brush::StraightLine{};
    EXPECT_EQ(moved_along(hand, {{}, {10.0, -5.0}}).guide, hand.guide) << "a straight line lies nowhere";
}

}  // namespace
}  // namespace pastoso::tools
