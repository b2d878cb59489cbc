// How hard a pen presses as the painter wants it: what the pen tells, led along a curve.
#pragma once

#include "tools/curve_edit.hpp"

namespace pastoso::tools {

/// Curves to start from, as the hand feels them.
enum class ReadyCurve {
    Soft,    ///< a light hand presses hard
    Linear,  ///< as the pen tells it
    Firm     ///< a heavy hand presses little
};
brush::DynamicsCurve ready_curve(ReadyCurve which);

/// Whether the points lead from input 0 to input 1, all values are 0 to 1, and nowhere falls one.
bool is_pressure_curve(const CurvePoints& points);

/// Pressure 0 to 1 for one that the pen tells, whatever that is. No pressure stays none unless the curve
/// starts above it.
double mapped_pressure(const brush::DynamicsCurve& curve, double told);

/// Where a point comes to lie that is moved to `place`: between its neighbours and nowhere below the one
/// before or above the one behind it. The first and the last stay at their inputs.
brush::CurvePoint confined_rising(const CurvePoints& points, int index, const brush::CurvePoint& place);

/// Adds a point between two others, as confined_rising() has it, and returns its number; -1 where there
/// is no room.
int add_rising(CurvePoints& points, const brush::CurvePoint& place);

}  // namespace pastoso::tools
