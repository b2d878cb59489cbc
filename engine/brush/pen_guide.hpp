// What leads the pen besides the hand: a straight line, a ruler, an ellipse.
#pragma once

#include "brush/pen_sample.hpp"

#include <variant>
#include <vector>

namespace pastoso::brush {

/// The stroke is the straight line from where the pen came down to where it lifts.
struct StraightLine {
    friend bool operator==(const StraightLine&, const StraightLine&) = default;
};

/// A straight edge through two points, without ends.
struct Ruler {
    double x1_mm = 0.0, y1_mm = 0.0;
    double x2_mm = 100.0, y2_mm = 0.0;  ///< apart from the first
    friend bool operator==(const Ruler&, const Ruler&) = default;
};

/// An ellipse, or a circle.
struct EllipseCurve {
    double centre_x_mm = 0.0, centre_y_mm = 0.0;
    double half_width_mm = 50.0, half_height_mm = 50.0;  ///< > 0
    double turn_deg = 0.0;  ///< of the width's direction, clockwise on the canvas
    friend bool operator==(const EllipseCurve&, const EllipseCurve&) = default;
};

struct PenGuide {
    std::variant<std::monostate, StraightLine, Ruler, EllipseCurve> form{};
    /// A stroke that starts within this distance of a ruler or an ellipse runs along it; others run
    /// beside it: parallel, or along the ellipse of the same centre and proportions through their start.
    double reach_mm = 5.0;
    /// The width of the brush stands across the guide, instead of turning with the pen.
    bool turn_across = false;
    friend bool operator==(const PenGuide&, const PenGuide&) = default;
};

/// The sample led along a ruler or an ellipse: on a ruler its place is the nearest, on an ellipse the
/// one in the same direction from the centre, in units of the half axes. `down` is where the pen came
/// down, `before` the guided sample before this one (at first `down`). Only place and rotation change.
/// Without a guide, and for a straight line, which is not known before it ends, the sample itself.
PenSample guided(const PenGuide& guide, const PenSample& down, const PenSample& before,
                 const PenSample& sample);

/// The point of the segment that is nearest to the sample, with the sample's other values.
PenSample on_segment(const PenSample& sample, const PenSample& from, const PenSample& to);

/// A whole stroke on the segment from its first to its last sample, in order: where the pen went back,
/// the line waits for it. At least one sample.
std::vector<PenSample> straightened(std::vector<PenSample> samples, bool turn_across);

}  // namespace pastoso::brush
