// Footprints as cells see them: each cell gets the mean over it, not what lies in its middle.
#pragma once

#include <cmath>

namespace pastoso::brush {

/// What a cell of side 1 adds to a footprint's mean square radius. A triangle as wide as two cells has
/// 1/3; a little more leaves no dots (docs/decisions/0053-means-over-cells.md).
inline constexpr double kCellMeanSquare = 0.54;

/// The radius of a footprint whose mean square radius is that of a tool's own and of a cell together.
/// `own` and `resolved` are the mean squares of both in squares of their radii.
inline double resolved_radius_mm(double radius_mm, double own, double resolved, double cell_mm) {
    return std::sqrt((own * radius_mm * radius_mm + kCellMeanSquare * cell_mm * cell_mm) / resolved);
}

}  // namespace pastoso::brush
