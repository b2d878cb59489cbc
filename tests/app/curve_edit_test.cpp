#include "tools/curve_edit.hpp"

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

}  // namespace
}  // namespace pastoso::tools
