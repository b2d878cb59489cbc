// Mirror and radial symmetry: one movement of the hand, painted by several brushes at once.
#pragma once

#include "brush/hand_pose.hpp"
#include "brush/tip.hpp"

#include <vector>

namespace pastoso::brush {

/// Copies of the hand's movement: `count` of them turned evenly about a centre, and with a mirror each
/// of these reflected as well.
struct Symmetry {
    double centre_x_mm = 0.0, centre_y_mm = 0.0;
    double axis_deg = 90.0;  ///< direction of the mirror through the centre; 90 stands upright
    bool mirror = false;
    int count = 1;  ///< 1 to 16
    friend bool operator==(const Symmetry&, const Symmetry&) = default;
};

/// How one copy stands to the hand: p' = A p + b, A a rotation or a reflection.
struct Placement {
    double xx = 1.0, xy = 0.0, yx = 0.0, yy = 1.0;  ///< A, by rows
    double x_mm = 0.0, y_mm = 0.0;                  ///< b
    bool mirrored = false;                          ///< A is a reflection
};

/// The placements of all copies; the first is the hand's own. Angles that are multiples of 90 degrees
/// are exact.
std::vector<Placement> placements(const Symmetry& symmetry);

/// The hand's pose as a copy has it. A mirrored one fits a mirrored tip, whose x axis it reverses.
HandPose placed(const Placement& placement, const HandPose& hand);

/// The tip seen in a mirror that stands across its width: roots and hairs change sides.
Tip mirrored(Tip tip);

}  // namespace pastoso::brush
