#include "tools/mirrors.hpp"

#include "tools/guide_handles.hpp"

#include <cmath>

#include <gtest/gtest.h>

namespace pastoso::tools {
namespace {

using brush::Symmetry;

TEST(Mirrors, EveryChoiceIsKept) {
    for (const Mirrors from : {Mirrors{}, {true, false}, {false, true}, {true, true}}) {
        const Symmetry before = with_mirrors({}, from);
        EXPECT_EQ(mirrors_of(before), from);
        for (const Mirrors to : {Mirrors{}, {true, false}, {false, true}, {true, true}}) {
            const Symmetry after = with_mirrors(before, to);
            EXPECT_EQ(mirrors_of(after), to);
            EXPECT_EQ(after.count, to.upright && to.level ? 2 : 1);
        }
    }
}

TEST(Mirrors, BothTogetherAreTheFourImages) {
    // (1, 2) left and right, above and below the origin, in whatever order.
    double sum = 0.0;
    for (const brush::Placement& placement : brush::placements(with_mirrors({}, {true, true}))) {
        const double x = placement.xx + 2.0 * placement.xy, y = placement.yx + 2.0 * placement.yy;
        EXPECT_EQ(std::abs(x), 1.0);
        EXPECT_EQ(std::abs(y), 2.0);
        sum += 3.0 * x + y;
    }
    EXPECT_EQ(sum, 0.0);
}

TEST(Mirrors, ATurnedMirrorKeepsItsTurn) {
    Symmetry turned = with_mirrors({}, {true, false});
    turned.axis_deg = 70.0;
    EXPECT_EQ(mirrors_of(turned), (Mirrors{true, false}));
    EXPECT_EQ(with_mirrors(turned, {false, true}).axis_deg, 160.0);
    EXPECT_EQ(with_mirrors(turned, {true, true}).axis_deg, 70.0);
}

TEST(Mirrors, AroundManyCopiesThereIsOneMirror) {
    const Symmetry star = with_mirrors({.count = 6}, {true, false});
    EXPECT_EQ(star.count, 6);
    EXPECT_TRUE(star.mirror);
    EXPECT_EQ(mirrors_of(star), (Mirrors{true, true}));
    EXPECT_FALSE(with_mirrors(star, {false, true}).mirror);
    EXPECT_EQ(with_mirrors(star, {false, true}).count, 6);
}

class GuideHandles : public testing::Test {
  protected:
    static constexpr glm::dvec2 kCanvas_mm{60.0, 40.0};

    Hand hand() const {
        Hand hand;
        hand.symmetry = {.centre_x_mm = 30.0, .centre_y_mm = 20.0, .mirror = true};
        hand.laid.form = brush::Ruler{10.0, 10.0, 20.0, 10.0};
        return hand;
    }
};

TEST_F(GuideHandles, TheNearestWithinReachIsTaken) {
    const auto handles = guide_handles(hand(), kCanvas_mm);
    ASSERT_EQ(handles.size(), 5U);
    EXPECT_EQ(handle_at(handles, {10.4, 10.0}, 1.0)->handle, Handle::RulerStart);
    EXPECT_EQ(handle_at(handles, {15.0, 10.9}, 1.0)->handle, Handle::RulerMiddle);
    EXPECT_EQ(handle_at(handles, {30.0, 35.5}, 1.0)->handle, Handle::MirrorAxis);
    EXPECT_FALSE(handle_at(handles, {15.0, 12.0}, 1.0).has_value());
    EXPECT_TRUE(guide_handles(Hand{}, kCanvas_mm).empty());
}

TEST_F(GuideHandles, DragTheirGuides) {
    const auto symmetry = [&](Handle handle, const glm::dvec2& to, bool square) {
        return std::get<Symmetry>(dragged(hand(), handle, to, square));
    };
    EXPECT_EQ(symmetry(Handle::SymmetryCentre, {7.0, 8.0}, false).centre_x_mm, 7.0);
    EXPECT_DOUBLE_EQ(symmetry(Handle::MirrorAxis, {40.0, 30.0}, false).axis_deg, 45.0);
    EXPECT_DOUBLE_EQ(symmetry(Handle::MirrorAxis, {40.0, 31.0}, true).axis_deg, 45.0);
    const auto ruler = [&](Handle handle, const glm::dvec2& to, bool square) {
        return std::get<brush::Ruler>(
            std::get<brush::PenGuide>(dragged(hand(), handle, to, square)).form);
    };
    EXPECT_EQ(ruler(Handle::RulerMiddle, {25.0, 30.0}, false), (brush::Ruler{20, 30, 30, 30}));
    const brush::Ruler level = ruler(Handle::RulerEnd, {40.0, 11.0}, true);
    EXPECT_DOUBLE_EQ(level.y2_mm, 10.0);
    EXPECT_DOUBLE_EQ(level.x2_mm, 10.0 + std::hypot(30.0, 1.0));
}

TEST_F(GuideHandles, AnEllipseKeepsItsProportionsWhereThatIsWanted) {
    Hand with_ellipse;
    with_ellipse.laid.form = brush::EllipseCurve{50.0, 50.0, 20.0, 10.0, 0.0};
    const auto ellipse = [&](Handle handle, const glm::dvec2& to, bool square) {
        return std::get<brush::EllipseCurve>(
            std::get<brush::PenGuide>(dragged(with_ellipse, handle, to, square)).form);
    };
    EXPECT_EQ(ellipse(Handle::EllipseCentre, {1.0, 2.0}, false),
              (brush::EllipseCurve{1.0, 2.0, 20.0, 10.0, 0.0}));
    EXPECT_EQ(ellipse(Handle::EllipseWidth, {90.0, 50.0}, false),
              (brush::EllipseCurve{50.0, 50.0, 40.0, 10.0, 0.0}));
    EXPECT_EQ(ellipse(Handle::EllipseWidth, {90.0, 50.0}, true),
              (brush::EllipseCurve{50.0, 50.0, 40.0, 20.0, 0.0}));
    EXPECT_EQ(ellipse(Handle::EllipseHeight, {50.0, 80.0}, false).half_height_mm, 30.0);
    EXPECT_DOUBLE_EQ(ellipse(Handle::EllipseWidth, {50.0, 90.0}, false).turn_deg, 90.0);
}

TEST_F(GuideHandles, APointBesideTheCanvasIsHeldAtItsEdge) {
    Hand perspective;
    perspective.laid.form =
        brush::VanishingPoints{.count = 2, .x1_mm = 20.0, .y1_mm = 10.0, .x2_mm = 500.0, .y2_mm = 10.0};
    const auto handles = guide_handles(perspective, kCanvas_mm);
    ASSERT_EQ(handles.size(), 2U);
    EXPECT_EQ(handles[0].place_mm, glm::dvec2(20.0, 10.0));
    EXPECT_EQ(handles[1].handle, Handle::SecondPoint);
    EXPECT_EQ(handles[1].point_mm, glm::dvec2(500.0, 10.0));
    EXPECT_NEAR(handles[1].place_mm.x, 60.0 - 0.03 * 40.0, 1e-12);
    EXPECT_EQ(handles[1].place_mm.y, 10.0);
}

TEST_F(GuideHandles, ThePointsCarryTheHorizon) {
    Hand hand;
    const auto points = [&](Handle handle, const glm::dvec2& to, bool square) {
        return std::get<brush::VanishingPoints>(
            std::get<brush::PenGuide>(dragged(hand, handle, to, square)).form);
    };
    hand.laid.form = brush::VanishingPoints{.count = 2, .x2_mm = 100.0};
    const brush::VanishingPoints risen = points(Handle::SecondPoint, {50.0, 50.0}, false);
    EXPECT_EQ(risen.y2_mm, 50.0);
    EXPECT_DOUBLE_EQ(risen.level_deg, 45.0);
    EXPECT_DOUBLE_EQ(risen.upright_deg, 135.0);
    hand.laid.form = brush::VanishingPoints{.count = 1, .x1_mm = 10.0};
    EXPECT_EQ(guide_handles(hand, kCanvas_mm).size(), 2U);
    EXPECT_DOUBLE_EQ(points(Handle::Horizon, {20.0, 9.0}, true).level_deg, 45.0);
    EXPECT_DOUBLE_EQ(points(Handle::Horizon, {20.0, 9.0}, true).upright_deg, 135.0);
    EXPECT_EQ(points(Handle::FirstPoint, {3.0, 4.0}, false).x1_mm, 3.0);
}

TEST_F(GuideHandles, AGridIsTurnedAndSpacedByItsCrossings) {
    Hand hand;
    hand.laid.form = brush::Grid{10.0, 10.0, 0.0, 20.0, 120.0, 15.0};
    const auto grid = [&](Handle handle, const glm::dvec2& to) {
        return std::get<brush::Grid>(std::get<brush::PenGuide>(dragged(hand, handle, to, false)).form);
    };
    EXPECT_EQ(grid(Handle::GridMiddle, {1.0, 2.0}), (brush::Grid{1.0, 2.0, 0.0, 20.0, 120.0, 15.0}));
    for (const PlacedHandle& handle : guide_handles(hand, kCanvas_mm)) {
        const brush::Grid same = grid(handle.handle, handle.place_mm);
        EXPECT_NEAR(same.spacing_mm, 20.0, 1e-9) << "dragged to where it is";
        EXPECT_NEAR(same.other_spacing_mm, 15.0, 1e-9);
        EXPECT_NEAR(same.direction_deg, 0.0, 1e-9);
        EXPECT_NEAR(same.other_direction_deg, 120.0, 1e-9);
    }
    const brush::Grid turned = grid(Handle::GridAlong, {10.0, 50.0});
    EXPECT_NEAR(turned.direction_deg, 90.0, 1e-9);
    EXPECT_NEAR(turned.other_direction_deg, -150.0, 1e-9);
    EXPECT_NEAR(turned.other_spacing_mm, 40.0 * std::sin(2.0 * std::acos(-1.0) / 3.0), 1e-9);
}

}  // namespace
}  // namespace pastoso::tools
