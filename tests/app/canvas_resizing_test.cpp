#include "tools/canvas_resizing.hpp"

#include "core/units.hpp"

#include <cmath>

#include <glm/geometric.hpp>
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
    mask.set(10, 4, grid::kWhole / 2);
    EXPECT_EQ(cropped_to(selection(), wanted), std::nullopt) << "nothing is outlined";
    mask.set(20, 8, grid::kWhole);
    mask.set(103, 51, grid::kWhole);
    EXPECT_EQ(cropped_to(selection(), wanted), (document::ResizeCanvas{5.0, 2.0, 21.0, 11.0}));
    mask.set(0, 0, grid::kWhole);
    mask.set(239, 159, grid::kWhole);
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

/// With that guide on the canvas instead.
Hand laid(Hand hand, const decltype(brush::PenGuide::form)& form) {
    hand.laid.form = form;
    return hand;
}

TEST(CanvasResizing, GuidesTurn) {
    Hand hand;
    hand.symmetry = {.centre_x_mm = 30.0, .centre_y_mm = 20.0, .axis_deg = 30.0, .mirror = true};
    hand.laid.form = brush::Ruler{1.0, 2.0, 3.0, 4.0};
    const brush::EllipseCurve ellipse{5.0, 6.0, 7.0, 8.0, 9.0};
    hand.air.fan_x_mm = 1.0;
    const CanvasMove mirror{{true, 0}, {60.0, 0.0}}, right{{false, 1}, {40.0, 0.0}};
    const Hand mirrored = moved_along(hand, mirror), turned = moved_along(hand, right);
    EXPECT_EQ(mirrored.ruler(), (brush::Ruler{59.0, 2.0, 57.0, 4.0}));
    EXPECT_EQ(moved_along(laid(hand, ellipse), mirror).ellipse(),
              (brush::EllipseCurve{55.0, 6.0, 7.0, 8.0, -9.0}));
    EXPECT_EQ(mirrored.symmetry.axis_deg, -30.0);
    EXPECT_EQ(mirrored.air.fan_x_mm, 59.0);
    EXPECT_EQ(turned.ruler(), (brush::Ruler{38.0, 1.0, 36.0, 3.0}));
    EXPECT_EQ(moved_along(laid(hand, ellipse), right).ellipse(),
              (brush::EllipseCurve{34.0, 5.0, 7.0, 8.0, 99.0}));
    EXPECT_EQ(turned.symmetry.axis_deg, 120.0);
    EXPECT_EQ(moved_along(moved_along(laid(hand, ellipse), mirror), mirror).ellipse(), ellipse);
}

TEST(CanvasResizing, PerspectivesAndGridsTurn) {
    const brush::VanishingPoints points{.count = 2,
                                        .x1_mm = -10.0,
                                        .y1_mm = 20.0,
                                        .x2_mm = 90.0,
                                        .y2_mm = 25.0,
                                        .level_deg = 3.0,
                                        .upright_deg = 93.0};
    const brush::Grid grid{1.0, 2.0, 10.0, 5.0, 70.0, 7.0};
    const CanvasMove mirror{{true, 0}, {60.0, 0.0}}, right{{false, 1}, {40.0, 0.0}};
    const auto moved = [](const auto& form, const CanvasMove& move) {
        return std::get<std::remove_cvref_t<decltype(form)>>(
            moved_along(laid({}, form), move).laid.form);
    };
    EXPECT_EQ(moved(points, mirror),
              (brush::VanishingPoints{2, 70.0, 20.0, -30.0, 25.0, 60.0, 0.0, -3.0, -93.0}));
    EXPECT_EQ(moved(points, right),
              (brush::VanishingPoints{2, 20.0, -10.0, 15.0, 90.0, 40.0, 0.0, 93.0, -177.0}));
    EXPECT_EQ(moved(grid, mirror), (brush::Grid{59.0, 2.0, -10.0, 5.0, -70.0, 7.0}));
    EXPECT_EQ(moved(grid, right), (brush::Grid{38.0, 1.0, 100.0, 5.0, 160.0, 7.0}));
    EXPECT_EQ(moved(moved(grid, mirror), mirror), grid);
}

/// How far a point is from the n-th line of a family of a grid, mm.
double off_line(const brush::Grid& grid, double direction_deg, double spacing_mm, int n,
                const glm::dvec2& point) {
    const double angle = core::radians(direction_deg);
    const double beside =
        (point.y - grid.y_mm) * std::cos(angle) - (point.x - grid.x_mm) * std::sin(angle);
    return std::abs(std::abs(beside) - std::abs(n * spacing_mm));
}

TEST(CanvasResizing, AGridThatIsDrawnOutLiesOnTheSamePoints) {
    const brush::Grid grid{1.0, 2.0, 20.0, 5.0, 130.0, 7.0};
    const CanvasMove move{{}, {}, {3.0, 0.5}};
    const auto after = std::get<brush::Grid>(moved_along(laid({}, grid), move).laid.form);
    for (int n = -4; n <= 4; ++n)
        for (const double along_mm : {-30.0, 0.0, 17.0}) {
            const auto on_line = [&](double direction_deg, double spacing_mm) {
                const double angle = core::radians(direction_deg);
                const glm::dvec2 way(std::cos(angle), std::sin(angle));
                return glm::dvec2(grid.x_mm, grid.y_mm) + along_mm * way +
                       n * spacing_mm * glm::dvec2(-way.y, way.x);
            };
            EXPECT_NEAR(off_line(after, after.direction_deg, after.spacing_mm, n,
                                 move(on_line(grid.direction_deg, grid.spacing_mm))),
                        0.0, 1e-9);
            EXPECT_NEAR(off_line(after, after.other_direction_deg, after.other_spacing_mm, n,
                                 move(on_line(grid.other_direction_deg, grid.other_spacing_mm))),
                        0.0, 1e-9);
        }
}

TEST(CanvasResizing, OfAScaledCanvasTheWayThereAndBackIsKnown) {
    const auto with = [](const document::CanvasSettings& settings, double x, double y) {
        return document::BareCanvas{settings, {}, x, y};
    };
    const document::BareCanvas before = with(canvas(), 2.0, 1.0);
    const document::BareCanvas after = with(document::scaled({1.5, 0.5, 3.0}, canvas()), 2.0 * 1.5, 0.5);
    const CanvasMove there = move_between(before, after), back = move_between(after, before);
    EXPECT_EQ(there(glm::dvec2(10.0, 20.0)), glm::dvec2(15.0, 10.0));
    EXPECT_LT(glm::length(back(glm::dvec2(15.0, 10.0)) - glm::dvec2(10.0, 20.0)), 1e-12);
    const document::BareCanvas turned = with(document::turned({false, 1}, canvas()), 1.0, 2.0);
    EXPECT_EQ(move_between(before, turned), move_between(canvas(), turned.settings));
}

TEST(CanvasResizing, GuidesAreRotatedAboutTheMiddleAndBack) {
    const document::CanvasSettings rotated = document::rotated(document::RotateCanvas{30.0}, canvas());
    const document::BareCanvas before{.settings = canvas(), .support_mm = {}},
        after{.settings = rotated, .support_mm = {}, .rotated_deg = 30.0};
    const CanvasMove there = move_between(before, after), back = move_between(after, before);
    Hand hand;
    hand.symmetry = {.centre_x_mm = 30.0, .centre_y_mm = 20.0, .axis_deg = 45.0, .mirror = true};
    hand.laid.form = brush::Ruler{30.0, 20.0, 40.0, 20.0};
    const Hand moved = moved_along(hand, there);
    const brush::EllipseCurve ellipse{40.0, 20.0, 7.0, 8.0, 9.0};
    const auto moved_ellipse = moved_along(laid(hand, ellipse), there).ellipse();
    // The middles are of whole cells.
    const glm::dvec2 middle = 0.5 * glm::dvec2(rotated.width_mm, rotated.height_mm);
    const double cell_mm = 1.0 / rotated.px_per_mm;
    EXPECT_NEAR(moved.symmetry.centre_x_mm, middle.x, cell_mm);
    EXPECT_NEAR(moved.symmetry.centre_y_mm, middle.y, cell_mm);
    EXPECT_NEAR(moved.symmetry.axis_deg, 75.0, 1e-9);
    EXPECT_NEAR(moved.ruler()->x2_mm - moved.ruler()->x1_mm, 10.0 * std::sqrt(0.75), 1e-9);
    EXPECT_NEAR(moved.ruler()->y2_mm - moved.ruler()->y1_mm, 5.0, 1e-9);
    EXPECT_NEAR(moved_ellipse->turn_deg, 39.0, 1e-9);
    const Hand again = moved_along(moved, back);
    EXPECT_NEAR(again.ruler()->x2_mm, 40.0, 1e-9);
    EXPECT_NEAR(again.ruler()->y2_mm, 20.0, 1e-9);
    EXPECT_NEAR(again.symmetry.axis_deg, 45.0, 1e-9);
}

TEST(CanvasResizing, ARulerIsPutLevelOrUpright) {
    EXPECT_NEAR(straightening_deg({10.0, 20.0, 30.0, 20.0}), 0.0, 1e-9);
    const double shallow_deg = core::degrees(std::atan(0.1));
    EXPECT_NEAR(straightening_deg({0.0, 0.0, 20.0, 2.0}), -shallow_deg, 1e-9) << "it falls to the right";
    EXPECT_NEAR(straightening_deg({20.0, 2.0, 0.0, 0.0}), -shallow_deg, 1e-9) << "drawn to the left";
    EXPECT_NEAR(straightening_deg({0.0, 0.0, 20.0, -2.0}), shallow_deg, 1e-9);
    EXPECT_NEAR(straightening_deg({0.0, 0.0, 2.0, 20.0}), shallow_deg, 1e-9) << "nearly upright";
    Hand hand;
    hand.laid.form = brush::Ruler{3.0, 4.0, 25.0, 11.0};
    const Hand moved = moved_along(hand, {.rotated_deg = straightening_deg(*hand.ruler())});
    EXPECT_NEAR(moved.ruler()->y1_mm, moved.ruler()->y2_mm, 1e-9);
}

/// How far a point lies from an ellipse, in parts of its size.
double off(const brush::EllipseCurve& ellipse, const glm::dvec2& point) {
    const double turn = core::radians(ellipse.turn_deg);
    const glm::dvec2 from = point - glm::dvec2(ellipse.centre_x_mm, ellipse.centre_y_mm);
    const double along = from.x * std::cos(turn) + from.y * std::sin(turn);
    const double across = from.y * std::cos(turn) - from.x * std::sin(turn);
    return std::hypot(along / ellipse.half_width_mm, across / ellipse.half_height_mm) - 1.0;
}

TEST(CanvasResizing, GuidesAreDrawnOut) {
    Hand hand;
    hand.symmetry = {.centre_x_mm = 30.0, .centre_y_mm = 20.0, .axis_deg = 45.0, .mirror = true};
    hand.laid.form = brush::Ruler{1.0, 2.0, 3.0, 4.0};
    const CanvasMove wider{{}, {}, {4.0, 1.0}};
    EXPECT_EQ(moved_along(hand, wider).ruler(), (brush::Ruler{4.0, 2.0, 12.0, 4.0}));
    hand.air.fan_x_mm = 1.0;
    hand.air.fan_radius_mm = 10.0;
    for (const double turn_deg : {0.0, 30.0, 75.0, -50.0})
        for (const double half_height_mm : {3.0, 8.0, 20.0}) {
            hand.laid.form = brush::EllipseCurve{5.0, 6.0, 8.0, half_height_mm, turn_deg};
            const Hand moved = moved_along(hand, wider);
            EXPECT_NEAR(moved.symmetry.axis_deg, core::degrees(std::atan(0.25)), 1e-9);
            EXPECT_EQ(moved.air.fan_radius_mm, 20.0);
            const double turn = core::radians(turn_deg);
            for (double angle = 0.0; angle < 6.0; angle += 0.37) {
                const double along = 8.0 * std::cos(angle), across = half_height_mm * std::sin(angle);
                const double x_mm = 5.0 + along * std::cos(turn) - across * std::sin(turn);
                const double y_mm = 6.0 + along * std::sin(turn) + across * std::cos(turn);
                EXPECT_NEAR(off(*moved.ellipse(), {4.0 * x_mm, y_mm}), 0.0, 1e-9) << turn_deg;
            }
            const brush::EllipseCurve larger = *moved_along(hand, {{}, {}, {1.5, 1.5}}).ellipse();
            EXPECT_NEAR(larger.half_width_mm, 12.0, 1e-9) << "the same way round";
            EXPECT_NEAR(larger.half_height_mm, 1.5 * half_height_mm, 1e-9);
        }
}

TEST(CanvasResizing, GuidesFollow) {
    Hand hand;
    hand.symmetry = {.centre_x_mm = 30.0, .centre_y_mm = 20.0, .axis_deg = 45.0, .mirror = true};
    hand.laid.form = brush::Ruler{1.0, 2.0, 3.0, 4.0};
    hand.guide.form = hand.laid.form;
    hand.air.fan_x_mm = 1.0;
    const Hand moved = moved_along(hand, {{}, {10.0, -5.0}});
    EXPECT_EQ(
        moved.symmetry,
        (brush::Symmetry{.centre_x_mm = 40.0, .centre_y_mm = 15.0, .axis_deg = 45.0, .mirror = true}));
    EXPECT_EQ(moved.ruler(), (brush::Ruler{11.0, -3.0, 13.0, -1.0}));
    EXPECT_EQ(moved_along(laid(hand, brush::EllipseCurve{5.0, 6.0, 7.0, 8.0, 9.0}), {{}, {10.0, -5.0}})
                  .ellipse(),
              (brush::EllipseCurve{15.0, 1.0, 7.0, 8.0, 9.0}));
    EXPECT_EQ(moved.guide.form, decltype(moved.guide.form)(brush::Ruler{11.0, -3.0, 13.0, -1.0}));
    EXPECT_EQ(moved.air.fan_x_mm, 11.0);
    EXPECT_EQ(moved_along(moved, {{}, {-10.0, 5.0}}).ruler(), hand.ruler());
    hand.guide.form = brush::StraightLine{};
    EXPECT_EQ(moved_along(hand, {{}, {10.0, -5.0}}).guide, hand.guide) << "a straight line lies nowhere";
}

}  // namespace
}  // namespace pastoso::tools
