// What leads the pen besides the hand: a straight line, a ruler, an ellipse, a perspective, a grid.
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

/// The vanishing points of a perspective, wherever they lie. A stroke runs along the line through its
/// start and one of them, or in one of the directions that have no such point.
struct VanishingPoints {
    int count = 1;  ///< 1 to 3; the others have no part in it
    double x1_mm = 0.0, y1_mm = 0.0;
    double x2_mm = 0.0, y2_mm = 0.0;
    double x3_mm = 0.0, y3_mm = 0.0;
    double level_deg = 0.0;     ///< a direction of strokes under one point
    double upright_deg = 90.0;  ///< the same under one or two
    friend bool operator==(const VanishingPoints&, const VanishingPoints&) = default;
};

/// Two families of parallel lines, one of each through a point.
struct Grid {
    double x_mm = 0.0, y_mm = 0.0;
    double direction_deg = 0.0;  ///< of the first lines, clockwise on the canvas from the right
    double spacing_mm = 20.0;    ///< between neighbours of the first, > 0
    double other_direction_deg = 90.0;
    double other_spacing_mm = 20.0;
    friend bool operator==(const Grid&, const Grid&) = default;
};

struct PenGuide {
    std::variant<std::monostate, StraightLine, Ruler, EllipseCurve, VanishingPoints, Grid> form{};
    /// A stroke that starts within this distance of a ruler, an ellipse or a line of a grid runs along
    /// it; others run beside it: parallel, or along the ellipse of the same centre and proportions
    /// through their start. With 0 all do.
    double reach_mm = 5.0;
    /// The width of the brush stands across the guide, instead of turning with the pen.
    bool turn_across = false;
    /// How far the guide takes the pen from where the hand is to where it leads, 0 to 1. A straight line
    /// is straight whatever the strength.
    double strength = 1.0;
    friend bool operator==(const PenGuide&, const PenGuide&) = default;
};

/// The sample led along a ruler or an ellipse: on a ruler its place is the nearest, on an ellipse the
/// one in the same direction from the centre, in units of the half axes. `down` is where the pen came
/// down, `before` the guided sample before this one (at first `down`). Only place and rotation change.
/// The sample itself without a guide or strength, and for what a stroke has to be known for
/// (GuideChoice): lines, perspectives and grids.
PenSample guided(const PenGuide& guide, const PenSample& down, const PenSample& before,
                 const PenSample& sample);

/// A perspective or a grid as one stroke keeps to it: the ruler whose direction fits best the hand's way
/// from `down` to `now`; of directions that fit alike the first. Through `down`, or along the line of
/// the grid that is within reach of it. No form where the hand has not moved, or is on the only
/// vanishing point that there is.
PenGuide chosen_for_stroke(const PenGuide& guide, const PenSample& down, const PenSample& now);

/// The point of the segment that is nearest to the sample, with the sample's other values.
PenSample on_segment(const PenSample& sample, const PenSample& from, const PenSample& to);

/// A whole stroke on the segment from its first to its last sample, in order: where the pen went back,
/// the line waits for it. At least one sample.
std::vector<PenSample> straightened(std::vector<PenSample> samples, bool turn_across);

}  // namespace pastoso::brush
