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
    Hand hand() const {
        Hand hand;
        hand.symmetry = {.centre_x_mm = 30.0, .centre_y_mm = 20.0, .mirror = true};
        hand.ruler = brush::Ruler{10.0, 10.0, 20.0, 10.0};
        return hand;
    }
};

TEST_F(GuideHandles, TheNearestWithinReachIsTaken) {
    const auto handles = guide_handles(hand(), 5.0);
    ASSERT_EQ(handles.size(), 5U);
    EXPECT_EQ(handle_at(handles, {10.4, 10.0}, 1.0)->handle, Handle::RulerStart);
    EXPECT_EQ(handle_at(handles, {15.0, 10.9}, 1.0)->handle, Handle::RulerMiddle);
    EXPECT_EQ(handle_at(handles, {30.0, 24.5}, 1.0)->handle, Handle::MirrorAxis);
    EXPECT_FALSE(handle_at(handles, {15.0, 12.0}, 1.0).has_value());
    EXPECT_TRUE(guide_handles(Hand{}, 5.0).empty());
}

TEST_F(GuideHandles, DragTheirGuides) {
    const auto symmetry = [&](Handle handle, const glm::dvec2& to, bool square) {
        return std::get<Symmetry>(dragged(hand(), handle, to, square));
    };
    EXPECT_EQ(symmetry(Handle::SymmetryCentre, {7.0, 8.0}, false).centre_x_mm, 7.0);
    EXPECT_DOUBLE_EQ(symmetry(Handle::MirrorAxis, {40.0, 30.0}, false).axis_deg, 45.0);
    EXPECT_DOUBLE_EQ(symmetry(Handle::MirrorAxis, {40.0, 31.0}, true).axis_deg, 45.0);
    const auto ruler = [&](Handle handle, const glm::dvec2& to, bool square) {
        return std::get<brush::Ruler>(dragged(hand(), handle, to, square));
    };
    EXPECT_EQ(ruler(Handle::RulerMiddle, {25.0, 30.0}, false), (brush::Ruler{20, 30, 30, 30}));
    const brush::Ruler level = ruler(Handle::RulerEnd, {40.0, 11.0}, true);
    EXPECT_DOUBLE_EQ(level.y2_mm, 10.0);
    EXPECT_DOUBLE_EQ(level.x2_mm, 10.0 + std::hypot(30.0, 1.0));
}

TEST_F(GuideHandles, AnEllipseKeepsItsProportionsWhereThatIsWanted) {
    Hand with_ellipse;
    with_ellipse.ellipse = brush::EllipseCurve{50.0, 50.0, 20.0, 10.0, 0.0};
    const auto ellipse = [&](Handle handle, const glm::dvec2& to, bool square) {
        return std::get<brush::EllipseCurve>(dragged(with_ellipse, handle, to, square));
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

}  // namespace
}  // namespace pastoso::tools
