// Editing of a dynamics curve, point by point.
#pragma once

#include "brush/preset.hpp"

#include <vector>

namespace pastoso::tools {

using CurvePoints = std::vector<brush::CurvePoint>;

/// What a curve's editor shows: inputs from 0, outputs between two bounds.
struct CurveFrame {
    double most_input = 1.0;
    double least_output = 0.0, most_output = 1.0;
    friend bool operator==(const CurveFrame&, const CurveFrame&) = default;
};

/// The frame that a curve of this kind is edited in, wide enough for the points that it has.
CurveFrame frame_of(const brush::DynamicsCurve& curve);

/// Points of a curve are at least this share of the frame's width apart.
inline constexpr double kLeastGap = 0.005;

/// The point at (input, output) brought into the frame and, for point `index`, between its neighbours.
brush::CurvePoint confined(const CurvePoints& points, int index, const brush::CurvePoint& place,
                           const CurveFrame& frame);

/// Puts a point in. Returns its index, or -1 where there is no room: next to another point, or beyond
/// the 64 that a curve may have.
int add_point(CurvePoints& points, const brush::CurvePoint& place, const CurveFrame& frame);

/// Takes a point out; the last one stays.
void remove_point(CurvePoints& points, int index);

using Curves = std::vector<brush::DynamicsCurve>;

/// Whether a tool of that kind feels a curve from the input to the target.
bool matters(brush::DynamicsInput input, brush::DynamicsTarget target, brush::ToolKind kind);

/// The first curve from the input to the target, or -1.
int find_curve(const Curves& curves, brush::DynamicsInput input, brush::DynamicsTarget target);

/// Adds a curve that leaves the tool as it was, to be bent from there, and returns its index. What
/// presses or turns a tool besides the pressure and the barrel leaves these their say: both are then
/// there as curves.
int add_curve(Curves& curves, brush::DynamicsInput input, brush::DynamicsTarget target);

}  // namespace pastoso::tools
