// How told pressure becomes meant pressure.
#include "tools/pressure_curve.hpp"

#include <limits>

#include <gtest/gtest.h>

namespace pastoso::tools {
namespace {

constexpr ReadyCurve kAll[] = {ReadyCurve::Soft, ReadyCurve::Linear, ReadyCurve::Firm};

TEST(PressureCurve, ReadyOnesRiseFromNoneToAll) {
    for (const ReadyCurve which : kAll) {
        const brush::DynamicsCurve curve = ready_curve(which);
        EXPECT_TRUE(is_pressure_curve(curve.points));
        EXPECT_EQ(mapped_pressure(curve, 0.0), 0.0);
        EXPECT_EQ(mapped_pressure(curve, 1.0), 1.0);
        for (int i = 0; i < 100; ++i)
            EXPECT_LT(mapped_pressure(curve, 0.01 * i), mapped_pressure(curve, 0.01 * (i + 1)));
    }
}

TEST(PressureCurve, SoftPressesMoreAndFirmLessThanIsTold) {
    for (int i = 1; i < 20; ++i) {
        const double told = 0.05 * i;
        EXPECT_GT(mapped_pressure(ready_curve(ReadyCurve::Soft), told), told);
        EXPECT_EQ(mapped_pressure(ready_curve(ReadyCurve::Linear), told), told);
        EXPECT_LT(mapped_pressure(ready_curve(ReadyCurve::Firm), told), told);
    }
}

TEST(PressureCurve, WhateverIsToldTheResultIsAPressure) {
    const brush::DynamicsCurve curve = ready_curve(ReadyCurve::Soft);
    EXPECT_EQ(mapped_pressure(curve, -3.0), 0.0);
    EXPECT_EQ(mapped_pressure(curve, 7.0), 1.0);
    EXPECT_EQ(mapped_pressure(curve, std::numeric_limits<double>::quiet_NaN()), 0.0);
    EXPECT_EQ(mapped_pressure(curve, std::numeric_limits<double>::infinity()), 1.0);
}

TEST(PressureCurve, StartsAboveNoneOnlyWhereThePainterLiftsIt) {
    CurvePoints points = ready_curve(ReadyCurve::Linear).points;
    points[0] = confined_rising(points, 0, {0.3, 0.2});
    EXPECT_EQ(points[0], (brush::CurvePoint{0.0, 0.2}));
    brush::DynamicsCurve curve = ready_curve(ReadyCurve::Linear);
    curve.points = points;
    EXPECT_EQ(mapped_pressure(curve, 0.0), 0.2);
}

TEST(PressureCurve, PointsStayBetweenTheirNeighbours) {
    CurvePoints points = {{0.0, 0.0}, {0.3, 0.2}, {0.6, 0.7}, {1.0, 1.0}};
    EXPECT_EQ(confined_rising(points, 1, {0.4, 0.9}), (brush::CurvePoint{0.4, 0.7}));
    EXPECT_EQ(confined_rising(points, 2, {0.5, 0.1}), (brush::CurvePoint{0.5, 0.2}));
    EXPECT_EQ(confined_rising(points, 3, {0.5, 0.1}), (brush::CurvePoint{1.0, 0.7}));
    EXPECT_LT(confined_rising(points, 1, {2.0, 0.5}).input, 0.6);
    for (int i = 0; i < 4; ++i) {
        for (const brush::CurvePoint& place : {brush::CurvePoint{-1, 2}, {2, -1}, {0.5, 0.5}}) {
            CurvePoints moved = points;
            moved[static_cast<std::size_t>(i)] = confined_rising(points, i, place);
            EXPECT_TRUE(is_pressure_curve(moved));
        }
    }
}

TEST(PressureCurve, AnAddedPointBreaksNoRise) {
    CurvePoints points = {{0.0, 0.0}, {0.5, 0.6}, {1.0, 1.0}};
    EXPECT_EQ(add_rising(points, {0.25, 0.9}), 1);
    EXPECT_EQ(points[1], (brush::CurvePoint{0.25, 0.6}));
    EXPECT_TRUE(is_pressure_curve(points));
    EXPECT_EQ(add_rising(points, {1.0, 0.5}), -1);
}

TEST(PressureCurve, TellsWhatIsNone) {
    EXPECT_FALSE(is_pressure_curve({}));
    EXPECT_FALSE(is_pressure_curve({{0.0, 0.0}}));
    EXPECT_FALSE(is_pressure_curve({{0.1, 0.0}, {1.0, 1.0}}));
    EXPECT_FALSE(is_pressure_curve({{0.0, 0.0}, {0.9, 1.0}}));
    EXPECT_FALSE(is_pressure_curve({{0.0, 0.5}, {1.0, 0.4}}));
    EXPECT_FALSE(is_pressure_curve({{0.0, 0.0}, {0.5, 0.2}, {0.5, 0.3}, {1.0, 1.0}}));
    EXPECT_FALSE(is_pressure_curve({{0.0, 0.0}, {1.0, 1.5}}));
}

}  // namespace
}  // namespace pastoso::tools
