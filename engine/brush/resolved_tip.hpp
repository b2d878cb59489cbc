// A tip as cells of one size see it. What is finer than a cell is there as its mean over the cell: cells
// that looked at it in their middles alone would make rows of dots of a hair that crosses them aslant.
//
// With a the side of a cell, r the radius of a bristle's footprint and rho the distance from its middle
// in radii R of the resolved one, the footprint weighs
//
//   w(rho) = (1 - rho^2) (1 + crown rho^2),   R^2 = (3/8 r^2 + k a^2) (6 + 2 crown) / (2 + crown).
//
// Its mean square radius is that of 1 - rho^4 on the radius r and of a cell together, and so is its mean
// fourth power over the square of that,
//
//   K = (r^4 / 5 + 3/2 k r^2 a^2 + 17/10 k^2 a^4) / (3/8 r^2 + k a^2)^2,
//   crown = 1 / (1 - sqrt(4 - 5/2 K)) - 2,   4 - 5/2 K at least 0,
//
// where a cell has k = 0.5 and the fourth power of a triangle. The finer cells are, the nearer it comes
// to 1 - rho^4 (crown 1), flat on top; where the radius is 2.5 cells or less it is (1 - rho^2)^2 (crown
// -1), which meets the canvas without an edge that cells could only draw as steps. R has k from 0.6
// (crown -1) to 0.5 (crown 1). `share` keeps its sum over the canvas.
//
// It covers 0.64 of a cell in whose middle the tip's own footprint ends, and of others the share
// min(1, cover w).
//
// A bristle's underside is higher than tau by film sat^2 profile(s), s from -1 to 1 across the resolved
// footprint: groove (s^2 + 1/4) + hair noise(s), each the mean over triangles of half width
// (0.97 + 0.72 slope) a, slope = 2 groove film / r being the groove's at its sides, and 2.5 a (3.2 a for
// a knife's scratches), weighed as 1 - s^4, the footprint's own weight.
//
// The elements of a knife weigh 1 - t^4 along their lanes and across them the mean of 1 - |s| over the
// width of a cell (brush/lane_weight.hpp), cover all of what they touch and have no grooves.
#pragma once

#include "brush/preset.hpp"
#include "brush/tip.hpp"

#include <cstddef>
#include <vector>

namespace pastoso::brush {

struct ResolvedTip {
    double radius_mm = 0.0;  ///< R; half length of a knife's lane
    double reach_mm = 0.0;   ///< w is below 0.04 beyond it, and left out; a knife's is 0
    double lane_mm = 0.0;    ///< half width that a knife element's lane reaches over, 0 for bristles
    float lane_core = 1.0F;  ///< the tip's own half width of a lane, of that
    float crown = 1.0F;      ///< -1 to 1
    float cover = 1e6F;      ///< share of a cell that a bristle covers, over its weight there
    float share = 1.0F;      ///< sum of the tip's own weight over that of the resolved one
    int segments = 16;       ///< of a profile, between segments + 1 heights
    std::vector<float> profiles;

    /// From one side of the resolved footprint to the other.
    const float* profile_of(int bristle) const {
        return &profiles[static_cast<std::size_t>(bristle) * (static_cast<std::size_t>(segments) + 1)];
    }
};
ResolvedTip resolve(const Tip& tip, const PaintPreset& paint, double cell_mm);

}  // namespace pastoso::brush
