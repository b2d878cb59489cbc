// Strokes are as smooth on coarse cells as on fine ones: the bounds, for the two tests of them.
#pragma once

#include "brush/stroke_slopes.hpp"

#include <algorithm>

#include <gtest/gtest.h>

namespace pastoso::brush::studio {

/// Eight of different kind.
inline constexpr const char* kSmoothPresets[] = {
    "flat bristle 20", "round bristle 12", "filbert 14",       "fan 26",
    "detail round 3",  "dry scumbler 22",  "palette knife 17", "soft glazing flat 16"};

/// A painter sees a slope of 0.012 as smooth, whatever finer cells have; along coarse cells, at most
/// 0.025.
inline void expect_smooth_on_coarse_cells(const StraightStroke& stroke) {
    const Slopes fine = slopes_of(painted(stroke, 16.0), stroke);
    const Slopes live = slopes_of(painted(stroke, 8.0), stroke);
    const Slopes coarse = slopes_of(painted(stroke, 4.0), stroke);
    EXPECT_LE(live.along, std::max(1.5 * fine.along, 0.012));
    EXPECT_LE(coarse.along, 0.025);
}

}  // namespace pastoso::brush::studio
