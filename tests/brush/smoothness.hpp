// Strokes are as smooth on coarse cells as on fine ones, and keep their relief: the bounds, for the two
// tests of them.
#pragma once

#include "brush/stroke_slopes.hpp"

#include <algorithm>
#include <vector>

#include <gtest/gtest.h>

namespace pastoso::brush::studio {

/// Eight of different kind.
inline constexpr const char* kSmoothPresets[] = {
    "flat bristle 20", "round bristle 12", "filbert 14",       "fan 26",
    "detail round 3",  "dry scumbler 22",  "palette knife 17", "soft glazing flat 16"};

/// A painter sees a slope of 0.012 as smooth, whatever finer cells have; along coarse cells, at most
/// 0.025. Across, strokes of a preset keep what cells can show of the relief that 16 px/mm have, on the
/// mean: single ones differ, since hairs fall differently into cells.
inline void expect_slopes_of_fine_cells(const std::vector<StraightStroke>& strokes) {
    double live_share = 0.0, coarse_share = 0.0;
    for (const StraightStroke& stroke : strokes) {
        SCOPED_TRACE(testing::Message()
                     << "fill " << stroke.fill << ", " << stroke.angle_deg << " degrees");
        const film::FilmState finest = painted(stroke, 16.0);
        const Slopes live = slopes_of(painted(stroke, 8.0), stroke);
        const Slopes coarse = slopes_of(painted(stroke, 4.0), stroke);
        EXPECT_LE(live.along, std::max(1.5 * slopes_of(finest, stroke).along, 0.012));
        EXPECT_LE(coarse.along, 0.025);
        const auto count = static_cast<double>(strokes.size());
        live_share += live.across / slopes_of(finest, stroke, 2).across / count;
        coarse_share += coarse.across / slopes_of(finest, stroke, 4).across / count;
    }
    EXPECT_NEAR(live_share, 1.0, 0.1);
    EXPECT_NEAR(coarse_share, 1.0, 0.3);
}

}  // namespace pastoso::brush::studio
