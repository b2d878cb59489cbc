#include "tools/transform_frame.hpp"

#include "document/actions/actions.hpp"

#include <gtest/gtest.h>

namespace pastoso::tools {
namespace {

using Kind = FrameHold::Kind;

constexpr double kCell_mm = 0.25;

/// From (10, 20) to (50, 40).
TransformFrame frame() {
    return {.corner_mm = {10.0, 20.0}, .size_mm = {40.0, 20.0}};
}

void expect_near(const glm::dvec2& place, const glm::dvec2& wanted) {
    // Sines of right angles are no whole numbers.
    EXPECT_NEAR(place.x, wanted.x, 1e-12);
    EXPECT_NEAR(place.y, wanted.y, 1e-12);
}

TEST(TransformFrame, TakesPlacesAsTheEngineDoes) {
    TransformFrame turned = frame();
    expect_near(placed(turned, {12.0, 23.0}), {12.0, 23.0});
    turned.turn_deg = 90.0;
    turned.scale = {2.0, -1.0};
    turned.move_mm = {5.0, 1.0};
    // 20 to the right of the middle (30, 30), twice that, turned clockwise: 40 below; and the move.
    expect_near(placed(turned, {50.0, 30.0}), {35.0, 71.0});
    // 10 below it, mirrored 10 above, turned clockwise: 10 to the right.
    expect_near(placed(turned, {30.0, 40.0}), {45.0, 31.0});
    expect_near(handle_mm(turned, {1, 1}), {45.0, 71.0});
    expect_near(handle_mm(turned, {0, -1}), {25.0, 31.0});
}

TEST(TransformFrame, StandsAroundWholeCellsThatAreSquareWhenTurned) {
    const TransformFrame even = frame_around({40, 80, 200, 160}, kCell_mm);
    EXPECT_EQ(even, frame());
    const TransformFrame odd = frame_around({40, 80, 199, 160}, kCell_mm);
    EXPECT_EQ(odd, frame()) << "159 and 80 cells are made 160 and 80";
    TransformFrame turned = frame_around({0, 0, 3, 6}, 1.0);
    turned.turn_deg = 90.0;
    expect_near(handle_mm(turned, {-1, -1}), {5.0, 1.0});
}

TEST(TransformFrame, AHandleScalesInsideMovesOutsideTurns) {
    const auto hold = [](double x_mm, double y_mm) { return hold_at(frame(), {x_mm, y_mm}, 1.0); };
    EXPECT_EQ(hold(10.5, 20.5), (FrameHold{Kind::Scale, {-1, -1}}));
    EXPECT_EQ(hold(50.9, 30.0), (FrameHold{Kind::Scale, {1, 0}}));
    EXPECT_EQ(hold(30.0, 40.9), (FrameHold{Kind::Scale, {0, 1}}));
    EXPECT_EQ(hold(20.0, 25.0), (FrameHold{Kind::Move, {}}));
    EXPECT_EQ(hold(51.1, 30.0), (FrameHold{Kind::Turn, {}}));
    EXPECT_EQ(hold(20.0, 19.0), (FrameHold{Kind::Turn, {}}));
    TransformFrame turned = frame();
    turned.turn_deg = 90.0;
    turned.scale.x = -1.0;
    // Upright now, from (20, 10) to (40, 50), and what was on the left is below.
    EXPECT_EQ(hold_at(turned, {30.0, 50.0}, 1.0), (FrameHold{Kind::Scale, {-1, 0}}));
    EXPECT_EQ(hold_at(turned, {30.0, 45.0}, 1.0).kind, Kind::Move);
    EXPECT_EQ(hold_at(turned, {45.0, 30.0}, 1.0).kind, Kind::Turn);
    // One that is smaller on the screen than its handles is still moved by its middle.
    EXPECT_EQ(hold_at(frame(), {30.0, 30.0}, 100.0).kind, Kind::Move);
}

TEST(TransformFrame, IsMovedByWholeCells) {
    const FrameHold hold{Kind::Move, {}};
    const auto move = [&](const glm::dvec2& to_mm, bool constrained) {
        return dragged(frame(), hold, {30.0, 30.0}, to_mm, constrained, kCell_mm).move_mm;
    };
    EXPECT_EQ(move({33.1, 28.9}, false), glm::dvec2(3.0, -1.0));
    EXPECT_EQ(move({33.1, 28.9}, true), glm::dvec2(3.0, 0.0));
    EXPECT_EQ(move({31.0, 26.0}, true), glm::dvec2(0.0, -4.0));
}

TEST(TransformFrame, ACornerScalesFromTheOppositeOne) {
    const FrameHold lower_right{Kind::Scale, {1, 1}};
    // From (50, 40) to (70, 45), beside the handle by a millimetre.
    TransformFrame scaled = dragged(frame(), lower_right, {51.0, 40.0}, {71.0, 45.0}, false, kCell_mm);
    EXPECT_EQ(scaled.scale, glm::dvec2(1.5, 1.25));
    EXPECT_EQ(scaled.move_mm, glm::dvec2(10.0, 2.5));
    EXPECT_EQ(handle_mm(scaled, {-1, -1}), glm::dvec2(10.0, 20.0));
    EXPECT_EQ(handle_mm(scaled, {1, 1}), glm::dvec2(70.0, 45.0));
    // In proportion: the nearest place on the diagonal, which is (40, 20).
    scaled = dragged(frame(), lower_right, {50.0, 40.0}, {60.0, 45.0}, true, kCell_mm);
    EXPECT_EQ(scaled.scale, glm::dvec2(1.25, 1.25));
    scaled = dragged(frame(), {Kind::Scale, {-1, -1}}, {10.0, 20.0}, {30.0, 30.0}, true, kCell_mm);
    EXPECT_EQ(scaled.scale, glm::dvec2(0.5, 0.5));
    EXPECT_EQ(handle_mm(scaled, {1, 1}), glm::dvec2(50.0, 40.0));
}

TEST(TransformFrame, ASideScalesOneAxis) {
    TransformFrame scaled =
        dragged(frame(), {Kind::Scale, {-1, 0}}, {10.0, 30.0}, {30.0, 99.0}, false, kCell_mm);
    EXPECT_EQ(scaled.scale, glm::dvec2(0.5, 1.0));
    EXPECT_EQ(scaled.move_mm, glm::dvec2(10.0, 0.0));
    scaled = dragged(frame(), {Kind::Scale, {0, 1}}, {30.0, 40.0}, {30.0, 60.0}, true, kCell_mm);
    EXPECT_EQ(scaled.scale, glm::dvec2(2.0, 2.0));
    EXPECT_EQ(handle_mm(scaled, {0, -1}), glm::dvec2(30.0, 20.0));
}

TEST(TransformFrame, DraggingAcrossTheOppositeSideMirrors) {
    TransformFrame scaled =
        dragged(frame(), {Kind::Scale, {1, 0}}, {50.0, 30.0}, {-10.0, 30.0}, false, kCell_mm);
    EXPECT_EQ(scaled.scale, glm::dvec2(-0.5, 1.0));
    EXPECT_EQ(handle_mm(scaled, {-1, 0}), glm::dvec2(10.0, 30.0));
    scaled = dragged(frame(), {Kind::Scale, {1, 0}}, {50.0, 30.0}, {-10.0, 30.0}, true, kCell_mm);
    EXPECT_EQ(scaled.scale, glm::dvec2(-0.5, 0.5)) << "what is not dragged is not mirrored";
    scaled = dragged(frame(), {Kind::Scale, {1, 1}}, {50.0, 40.0}, {-30.0, 0.0}, true, kCell_mm);
    EXPECT_EQ(scaled.scale, glm::dvec2(-1.0, -1.0));
    // A mirrored one is scaled the same way, from its own opposite side.
    TransformFrame mirrored = frame();
    mirrored.scale.x = -1.0;
    scaled = dragged(mirrored, {Kind::Scale, {-1, 0}}, {50.0, 30.0}, {70.0, 30.0}, false, kCell_mm);
    EXPECT_EQ(scaled.scale, glm::dvec2(-1.5, 1.0));
    EXPECT_EQ(handle_mm(scaled, {1, 0}), glm::dvec2(10.0, 30.0));
}

TEST(TransformFrame, ATurnedOneIsScaledAlongItsOwnAxes) {
    TransformFrame turned = frame();
    turned.turn_deg = 90.0;
    // Its right side is at (30, 50) and faces down.
    const TransformFrame scaled =
        dragged(turned, {Kind::Scale, {1, 0}}, {30.0, 50.0}, {45.0, 70.0}, false, kCell_mm);
    expect_near(scaled.scale, {1.5, 1.0});
    expect_near(handle_mm(scaled, {-1, 0}), {30.0, 10.0});
    expect_near(handle_mm(scaled, {1, 0}), {30.0, 70.0});
}

TEST(TransformFrame, ScalesStayWithinTheLimits) {
    const FrameHold right{Kind::Scale, {1, 0}};
    const auto scale = [&](double to_x_mm) {
        return dragged(frame(), right, {50.0, 30.0}, {to_x_mm, 30.0}, false, kCell_mm).scale.x;
    };
    EXPECT_EQ(scale(10.0), document::kLeastScale);
    EXPECT_EQ(scale(9.9), -document::kLeastScale);
    EXPECT_EQ(scale(5000.0), document::kMostScale);
}

TEST(TransformFrame, IsTurnedAboutItsMiddle) {
    const FrameHold hold{Kind::Turn, {}};
    TransformFrame moved = frame();
    moved.move_mm = {5.0, 0.0};
    // About (35, 30), from the right to below it: clockwise.
    const TransformFrame turned = dragged(moved, hold, {75.0, 30.0}, {35.0, 70.0}, false, kCell_mm);
    EXPECT_EQ(turned.turn_deg, 90.0);
    EXPECT_EQ(turned.move_mm, moved.move_mm);
    EXPECT_EQ(dragged(turned, hold, {75.0, 30.0}, {-5.0, 29.0}, true, kCell_mm).turn_deg, -90.0);
    EXPECT_EQ(dragged(frame(), hold, {70.0, 30.0}, {70.0, 19.0}, true, kCell_mm).turn_deg, -15.0);
    EXPECT_NEAR(dragged(frame(), hold, {70.0, 30.0}, {70.0, 70.0}, false, kCell_mm).turn_deg, 45.0,
                1e-12);
}

TEST(TransformFrame, WithControlAHandleDistorts) {
    EXPECT_EQ(hold_at(frame(), {10.5, 20.5}, 1.0, true), (FrameHold{Kind::Distort, {-1, -1}}));
    EXPECT_EQ(hold_at(frame(), {30.0, 20.5}, 1.0, true), (FrameHold{Kind::Distort, {0, -1}}));
    EXPECT_EQ(hold_at(frame(), {20.0, 25.0}, 1.0, true).kind, Kind::Move);
    EXPECT_EQ(hold_at(frame(), {60.0, 25.0}, 1.0, true).kind, Kind::Turn);
}

TEST(TransformFrame, ACornerIsPulledAlone) {
    const FrameHold upper_right{Kind::Distort, {1, -1}};
    const TransformFrame pulled =
        dragged(frame(), upper_right, {50.0, 20.0}, {44.0, 25.0}, false, kCell_mm);
    EXPECT_TRUE(pulled.is_distorted());
    expect_near(handle_mm(pulled, {-1, -1}), {10.0, 20.0});
    expect_near(handle_mm(pulled, {1, -1}), {44.0, 25.0});
    expect_near(handle_mm(pulled, {1, 1}), {50.0, 40.0});
    expect_near(handle_mm(pulled, {-1, 1}), {10.0, 40.0});
    // Diagonals cross where they crossed, here at (s, 30) with s from (10, 40) to (44, 25).
    const glm::dvec2 middle = placed(pulled, {30.0, 30.0});
    EXPECT_NEAR((middle.x - 10.0) * (25.0 - 40.0), (middle.y - 40.0) * (44.0 - 10.0), 1e-9);
    EXPECT_NEAR((middle.x - 10.0) * (40.0 - 20.0), (middle.y - 20.0) * (50.0 - 10.0), 1e-9);
    const TransformFrame level =
        dragged(frame(), upper_right, {50.0, 20.0}, {44.0, 25.0}, true, kCell_mm);
    expect_near(handle_mm(level, {1, -1}), {44.0, 20.0});
    EXPECT_EQ(hold_at(pulled, {49.0, 22.0}, 1.0).kind, Kind::Turn) << "beside it now";
    EXPECT_EQ(hold_at(pulled, {40.0, 26.0}, 1.0).kind, Kind::Move);
}

TEST(TransformFrame, ASideIsPulledAskew) {
    const TransformFrame pulled =
        dragged(frame(), {Kind::Distort, {0, -1}}, {30.0, 20.0}, {37.0, 21.0}, true, kCell_mm);
    expect_near(handle_mm(pulled, {-1, -1}), {17.0, 20.0});
    expect_near(handle_mm(pulled, {1, -1}), {57.0, 20.0});
    expect_near(handle_mm(pulled, {1, 1}), {50.0, 40.0});
    EXPECT_NEAR(area_growth(pulled), 1.0, 1e-12);
    // A turned and mirrored one goes with the pointer, too.
    TransformFrame turned = frame();
    turned.turn_deg = 90.0;
    turned.scale = {-1.0, 2.0};
    const glm::dvec2 corner = handle_mm(turned, {1, 1});
    const glm::dvec2 way{-3.0, 4.0};
    const TransformFrame there =
        dragged(turned, {Kind::Distort, {1, 1}}, corner, corner + way, false, kCell_mm);
    expect_near(handle_mm(there, {1, 1}), corner + way);
    expect_near(handle_mm(there, {-1, 1}), handle_mm(turned, {-1, 1}));
}

TEST(TransformFrame, ADistortedOneIsMovedScaledAndTurnedAsItIs) {
    TransformFrame pulled =
        dragged(frame(), {Kind::Distort, {1, -1}}, {50.0, 20.0}, {44.0, 25.0}, false, kCell_mm);
    const TransformFrame moved =
        dragged(pulled, {Kind::Move, {}}, {30.0, 30.0}, {33.0, 31.0}, false, kCell_mm);
    expect_near(handle_mm(moved, {1, -1}), {47.0, 26.0});
    const TransformFrame scaled =
        dragged(pulled, {Kind::Scale, {1, 1}}, {50.0, 40.0}, {90.0, 60.0}, false, kCell_mm);
    expect_near(handle_mm(scaled, {-1, -1}), {10.0, 20.0});
    expect_near(handle_mm(scaled, {1, 1}), {90.0, 60.0});
    expect_near(handle_mm(scaled, {1, -1}), {78.0, 30.0});
    const layers::Distortion told = distortion_of(scaled);
    EXPECT_EQ(told.corner, (layers::Place{10.0, 20.0}));
    EXPECT_EQ(told.width_mm, 40.0);
    EXPECT_NEAR(told.upper_right.x_mm, 78.0, 1e-9);
    EXPECT_NEAR(told.lower_left.y_mm, 60.0, 1e-9);
}

TEST(TransformFrame, WhatFoldsSaysSo) {
    const auto to = [](double x_mm, double y_mm) {
        return dragged(frame(), {Kind::Distort, {1, 1}}, {50.0, 40.0}, {x_mm, y_mm}, false, kCell_mm);
    };
    EXPECT_TRUE(problem_of(frame()).empty());
    EXPECT_TRUE(problem_of(to(40.0, 38.0)).empty());
    EXPECT_FALSE(problem_of(to(20.0, 25.0)).empty()) << "bends inwards";
    EXPECT_FALSE(problem_of(to(30.0, 10.0)).empty()) << "crosses itself";
    EXPECT_FALSE(problem_of(to(50.0, 20.5)).empty()) << "a side is too short";
}

TEST(TransformFrame, WhatChangesNothingIsNotDone) {
    EXPECT_EQ(transform_of(frame(), kCell_mm), std::nullopt);
    TransformFrame moved = frame();
    moved.move_mm = {0.1, -0.1};
    EXPECT_EQ(transform_of(moved, kCell_mm), std::nullopt) << "less than half a cell";
    moved.move_mm = {0.3, -0.1};
    moved.turn_deg = -90.0;
    moved.scale = {-1.0, 1.0};
    EXPECT_EQ(transform_of(moved, kCell_mm), (layers::Transform{.centre_x_mm = 30.0,
                                                                .centre_y_mm = 30.0,
                                                                .move_x_mm = 0.25,
                                                                .turn_deg = -90.0,
                                                                .scale_x = -1.0}));
    moved.scale.x = 1.5;
    EXPECT_EQ(transform_of(moved, kCell_mm)->move_x_mm, 0.3) << "what is blurred anyway goes anywhere";
}

TEST(TransformFrame, SurroundsThePaintThatIsSelected) {
    document::Snapshot painting{.film = film::FilmState({100, 60}, kCell_mm)};
    EXPECT_TRUE(painted_cells(painting).empty());
    painting.film.thickness.set(12, 30, 5);
    film::StrataOptics dark = film::kClearStrata;
    dark[0] = 7;
    painting.film.strata.optics.set(70, 41, dark);
    EXPECT_EQ(painted_cells(painting), (grid::Rect{12, 30, 71, 42}));
    grid::Mask mask({100, 60});
    mask.set(70, 41, grid::kWhole);
    mask.set(5, 5, grid::kWhole);
    painting.selection = std::make_shared<const grid::Mask>(mask);
    EXPECT_EQ(painted_cells(painting), (grid::Rect{70, 41, 71, 42}));
    // What is masked stays where it is.
    mask.set(12, 30, grid::kWhole);
    grid::Mask masked({100, 60});
    masked.set(70, 41, grid::kWhole);
    painting.selection = std::make_shared<const grid::Mask>(mask);
    painting.masking.cells = std::make_shared<const grid::Mask>(masked);
    EXPECT_EQ(painted_cells(painting), (grid::Rect{12, 30, 13, 31}));
    painting.selection = nullptr;
    EXPECT_EQ(painted_cells(painting), (grid::Rect{12, 30, 13, 31}));
    // Of several layers, that of the active one.
    painting.active = std::make_shared<const film::FilmState>(grid::Shape{100, 60}, kCell_mm);
    EXPECT_TRUE(painted_cells(painting).empty());
}

}  // namespace
}  // namespace pastoso::tools
