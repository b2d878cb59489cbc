#include "tools/curve_edit.hpp"

#include "brush/hand_pose.hpp"

#include <gtest/gtest.h>

namespace pastoso::tools {
namespace {

using brush::CurvePoint;
using brush::DynamicsCurve;
using brush::DynamicsInput;
using brush::DynamicsTarget;

constexpr CurveFrame kUnit{1.0, 0.0, 1.0};

TEST(CurveFrame, HoldsTheUsualRangesAndWhatLiesBeyond) {
    EXPECT_EQ(frame_of({DynamicsInput::Pressure, DynamicsTarget::Press, {{0, 0}, {1, 1}}}), kUnit);
    EXPECT_EQ(frame_of({DynamicsInput::Speed, DynamicsTarget::Film, {{0, 1}, {900, 3.5}}}),
              (CurveFrame{900.0, 0.0, 3.5}));
    EXPECT_EQ(
        frame_of({DynamicsInput::BarrelRotation, DynamicsTarget::Rotation, {{0, -90}, {360, 270}}}),
        (CurveFrame{360.0, -90.0, 360.0}));
}

TEST(CurvePoints, AMovedPointStaysBetweenItsNeighbours) {
    const CurvePoints points = {{0, 0}, {0.5, 0.5}, {1, 1}};
    EXPECT_EQ(confined(points, 1, {0.25, 0.75}, kUnit), (CurvePoint{0.25, 0.75}));
    EXPECT_EQ(confined(points, 1, {-3, 2}, kUnit), (CurvePoint{kLeastGap, 1.0}));
    EXPECT_EQ(confined(points, 1, {7, -2}, kUnit), (CurvePoint{1.0 - kLeastGap, 0.0}));
    EXPECT_EQ(confined(points, 0, {-3, 0}, kUnit), (CurvePoint{0.0, 0.0}));
    EXPECT_EQ(confined(points, 2, {3, 0}, kUnit), (CurvePoint{1.0, 0.0}));
}

TEST(CurvePoints, AreAddedInOrderWhereThereIsRoom) {
    CurvePoints points = {{0.2, 0}, {0.8, 1}};
    EXPECT_EQ(add_point(points, {0.5, 0.25}, kUnit), 1);
    EXPECT_EQ(add_point(points, {0.1, 0.5}, kUnit), 0);
    EXPECT_EQ(add_point(points, {2.0, 2.0}, kUnit), 4);
    EXPECT_EQ(points, (CurvePoints{{0.1, 0.5}, {0.2, 0}, {0.5, 0.25}, {0.8, 1}, {1, 1}}));
    EXPECT_EQ(add_point(points, {0.501, 0.9}, kUnit), -1);
    EXPECT_EQ(points.size(), 5U);
}

TEST(CurvePoints, AreAtMostWhatAFileMayHold) {
    CurvePoints points;
    for (int i = 0; i < 64; ++i)
        points.push_back({i / 100.0, 0.0});
    EXPECT_EQ(add_point(points, {0.9, 0.5}, kUnit), -1);
}

TEST(CurvePoints, TheLastOneStays) {
    CurvePoints points = {{0, 0}, {1, 1}};
    remove_point(points, 0);
    EXPECT_EQ(points, (CurvePoints{{1, 1}}));
    remove_point(points, 0);
    EXPECT_EQ(points.size(), 1U);
}

// ---- adding curves

using brush::ToolKind;

/// What the curves of a tool make of the hand.
brush::HandPose pose_of(const Curves& curves, const brush::PenSample& pen, double speed_mm_s) {
    brush::PathStep step{};
    step.pen = pen;
    step.speed_mm_s = speed_mm_s;
    return brush::hand_pose(curves, step);
}

TEST(AddedCurves, ChangeNothingUntilTheyAreBent) {
    const std::vector<Curves> tools = {
        {}, {{DynamicsInput::Pressure, DynamicsTarget::Press, {{0, 0}, {0.3, 0.22}, {1, 1}}}}};
    for (const Curves& before : tools) {
        for (const auto input :
             {DynamicsInput::Pressure, DynamicsInput::Tilt, DynamicsInput::BarrelRotation,
              DynamicsInput::Speed, DynamicsInput::Direction, DynamicsInput::Distance,
              DynamicsInput::Time, DynamicsInput::Fade, DynamicsInput::StrokeRandom,
              DynamicsInput::DabRandom, DynamicsInput::Wheel, DynamicsInput::Load}) {
            for (const auto target :
                 {DynamicsTarget::Press, DynamicsTarget::Lean, DynamicsTarget::Rotation,
                  DynamicsTarget::Film, DynamicsTarget::Pickup, DynamicsTarget::Spread}) {
                if (!brush::can_set(input, target)) continue;
                Curves after = before;
                const int added = add_curve(after, input, target);
                EXPECT_EQ(after[static_cast<std::size_t>(added)].input, input);
                EXPECT_EQ(after[static_cast<std::size_t>(added)].target, target);
                const brush::PenSample pen{.pressure = 0.4, .tilt_x_deg = 15.0, .rotation_deg = 70.0};
                const brush::HandPose was = pose_of(before, pen, 90.0), is = pose_of(after, pen, 90.0);
                EXPECT_NEAR(is.press, was.press, 1e-12);
                EXPECT_NEAR(is.lean_x, was.lean_x, 5e-3);  // the tangent, to two digits
                EXPECT_NEAR(is.cos_rotation, was.cos_rotation, 1e-12);
                EXPECT_EQ(is.film, was.film);
                EXPECT_EQ(is.pickup, was.pickup);
                EXPECT_EQ(is.spread, was.spread);
            }
        }
    }
}

TEST(AddedCurves, LeaveThePressureItsSay) {
    Curves curves;
    EXPECT_EQ(add_curve(curves, DynamicsInput::Speed, DynamicsTarget::Press), 1);
    EXPECT_EQ(find_curve(curves, DynamicsInput::Pressure, DynamicsTarget::Press), 0);
    EXPECT_EQ(find_curve(curves, DynamicsInput::Tilt, DynamicsTarget::Press), -1);
}

TEST(AddedCurves, LeaveTheBarrelItsSay) {
    Curves curves;
    EXPECT_EQ(add_curve(curves, DynamicsInput::Direction, DynamicsTarget::Rotation), 1);
    EXPECT_EQ(find_curve(curves, DynamicsInput::BarrelRotation, DynamicsTarget::Rotation), 0);
    EXPECT_EQ(curves[1].points, (CurvePoints{{0.0, 0.0}, {360.0, 0.0}}));
}

TEST(AddedCurves, AreThoseThatTheToolFeels) {
    EXPECT_TRUE(matters(DynamicsInput::Speed, DynamicsTarget::Film, ToolKind::Contact));
    EXPECT_FALSE(matters(DynamicsInput::Speed, DynamicsTarget::Film, ToolKind::Air));
    EXPECT_TRUE(matters(DynamicsInput::Speed, DynamicsTarget::Flow, ToolKind::Droplets));
    EXPECT_FALSE(matters(DynamicsInput::Speed, DynamicsTarget::Flow, ToolKind::Contact));
    EXPECT_FALSE(matters(DynamicsInput::Speed, DynamicsTarget::Lean, ToolKind::Contact));
}

}  // namespace
}  // namespace pastoso::tools
