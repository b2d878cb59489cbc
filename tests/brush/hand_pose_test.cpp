#include "brush/hand_pose.hpp"

#include <cmath>

#include <gtest/gtest.h>

namespace pastoso::brush {
namespace {

const DynamicsCurve kCurve = {
    DynamicsInput::Pressure, DynamicsTarget::Press, {{0.0, 0.0}, {0.3, 0.22}, {1.0, 1.0}}};

PathStep step_with(const PenSample& pen, double speed_mm_s = 0.0) {
    return {pen, 1.0, 0.0, speed_mm_s};
}

TEST(DynamicsCurve, IsLinearBetweenPointsAndConstantBeyond) {
    EXPECT_DOUBLE_EQ(evaluate(kCurve, -1.0), 0.0);
    EXPECT_DOUBLE_EQ(evaluate(kCurve, 0.15), 0.11);
    EXPECT_DOUBLE_EQ(evaluate(kCurve, 0.3), 0.22);
    EXPECT_DOUBLE_EQ(evaluate(kCurve, 0.65), 0.61);
    EXPECT_DOUBLE_EQ(evaluate(kCurve, 2.0), 1.0);
}

TEST(HandPose, WithoutCurvesFollowsThePen) {
    const HandPose pose =
        hand_pose({}, step_with({.pressure = 0.37, .tilt_x_deg = 45.0, .rotation_deg = 90.0}, 1000.0));
    EXPECT_DOUBLE_EQ(pose.press, 0.37);
    EXPECT_NEAR(pose.lean_x, 1.0, 1e-12);
    EXPECT_NEAR(pose.lean_y, 0.0, 1e-12);
    EXPECT_NEAR(pose.sin_rotation, 1.0, 1e-12);
    EXPECT_DOUBLE_EQ(pose.reach, 1.0);
}

TEST(HandPose, AppliesThePresetsCurves) {
    const std::vector<DynamicsCurve>& curves = find_preset("flat").dynamics;
    const HandPose pose = hand_pose(
        curves, step_with({.pressure = 0.15, .tilt_x_deg = -60.0, .rotation_deg = 390.0}, 200.0));
    EXPECT_DOUBLE_EQ(pose.press, 0.11);
    EXPECT_NEAR(pose.lean_x, -1.0, 1e-12);
    EXPECT_NEAR(pose.cos_rotation, std::cos(std::acos(-1.0) / 6.0), 1e-12);
    EXPECT_NEAR(pose.reach, 0.8, 1e-12);
}

TEST(HandPose, MultipliesCurvesOfOneTarget) {
    const DynamicsCurve by_speed = {
        DynamicsInput::Speed, DynamicsTarget::Press, {{0.0, 1.0}, {100.0, 0.5}}};
    const HandPose pose = hand_pose({kCurve, by_speed}, step_with({.pressure = 1.0}, 50.0));
    EXPECT_DOUBLE_EQ(pose.press, 0.75);
}

TEST(HandPose, MirroredTiltLeansTheOtherWay) {
    const auto& curves = find_preset("round").dynamics;
    const HandPose a = hand_pose(curves, step_with({.tilt_x_deg = 20.0, .tilt_y_deg = 30.0}));
    const HandPose b = hand_pose(curves, step_with({.tilt_x_deg = -20.0, .tilt_y_deg = 30.0}));
    EXPECT_DOUBLE_EQ(a.lean_x, -b.lean_x);
    EXPECT_DOUBLE_EQ(a.lean_y, b.lean_y);
    EXPECT_GT(a.lean_y, a.lean_x);
}

}  // namespace
}  // namespace pastoso::brush
