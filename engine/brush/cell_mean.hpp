// Footprints as cells see them: each cell gets the mean over it, not what lies in its middle.
#pragma once

#include <cmath>

namespace pastoso::brush {

/// What a cell of side 1 adds to the mean square radius of a footprint without an edge, and of one that
/// is flat on top. A triangle as wide as two cells has 1/3; a little more leaves no dots
/// (docs/decisions/0053-means-over-cells.md).
inline constexpr double kSoftCellSquare = 0.6, kFirmCellSquare = 0.5;

/// The share that a lane's own half width has of the one that it reaches over on cells, each of which
/// gets the mean of the lane's weight over its width (brush/lane_weight.hpp).
inline double lane_core(double lane_mm, double cell_mm) {
    return lane_mm / (lane_mm + 0.5 * cell_mm);
}

/// A lane as cells see it.
struct LaneOnCells {
    float core;       ///< lane_core()
    double reach_mm;  ///< half width
};
inline LaneOnCells lane_on_cells(double lane_mm, double cell_mm) {
    const auto core = static_cast<float>(lane_core(lane_mm, cell_mm));
    return {core, lane_mm / core};
}

/// Mean squares of a tool's own footprint and of the resolved one, in squares of their radii, and of
/// what a cell adds, in squares of its side.
struct MeanSquares {
    double own, resolved, cell;
};

/// The radius of a footprint whose mean square radius is that of a tool's own and of a cell together.
inline double resolved_radius_mm(const MeanSquares& squares, double radius_mm, double cell_mm) {
    const double square_mm2 = squares.own * radius_mm * radius_mm + squares.cell * cell_mm * cell_mm;
    return std::sqrt(square_mm2 / squares.resolved);
}

}  // namespace pastoso::brush
