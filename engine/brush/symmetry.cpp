#include "brush/symmetry.hpp"

#include "core/check.hpp"
#include "core/units.hpp"

#include <algorithm>
#include <cmath>

namespace pastoso::brush {
namespace {

struct Vector {
    double x = 0.0, y = 0.0;
};

/// The unit vector at an angle, exact at multiples of 90 degrees.
Vector unit_at(double angle_deg) {
    const double quarters = std::round(angle_deg / 90.0);
    const double rest = core::radians(angle_deg - 90.0 * quarters);
    const double c = std::cos(rest), s = std::sin(rest);
    switch (static_cast<int>(quarters - 4.0 * std::floor(quarters / 4.0))) {
        case 1:
            return {-s, c};
        case 2:
            return {-c, -s};
        case 3:
            return {s, -c};
        default:
            return {c, s};
    }
}

/// b, so that the centre stays where it is.
Placement about_centre(Placement placement, const Symmetry& symmetry) {
    const double x = symmetry.centre_x_mm, y = symmetry.centre_y_mm;
    placement.x_mm = x - (placement.xx * x + placement.xy * y);
    placement.y_mm = y - (placement.yx * x + placement.yy * y);
    return placement;
}

Placement turned(double angle_deg, const Symmetry& symmetry) {
    const Vector u = unit_at(angle_deg);
    return about_centre({.xx = u.x, .xy = -u.y, .yx = u.y, .yy = u.x}, symmetry);
}

/// Reflected at a line through the centre.
Placement reflected(double axis_deg, const Symmetry& symmetry) {
    const Vector u = unit_at(2.0 * axis_deg);
    return about_centre({.xx = u.x, .xy = u.y, .yx = u.y, .yy = -u.x, .mirrored = true}, symmetry);
}

}  // namespace

std::vector<Placement> placements(const Symmetry& symmetry) {
    PASTOSO_CHECK_OP(symmetry.count, >=, 1);
    std::vector<Placement> result;
    for (int i = 0; i < symmetry.count; ++i) {
        const double turn_deg = 360.0 * i / symmetry.count;
        result.push_back(i == 0 ? Placement{} : turned(turn_deg, symmetry));
        if (symmetry.mirror) result.push_back(reflected(symmetry.axis_deg + 0.5 * turn_deg, symmetry));
    }
    return result;
}

HandPose placed(const Placement& placement, const HandPose& hand) {
    const auto turned = [&](double x, double y) {
        return Vector{placement.xx * x + placement.xy * y, placement.yx * x + placement.yy * y};
    };
    const Vector place = turned(hand.x_mm, hand.y_mm), travel = turned(hand.travel_x, hand.travel_y);
    const Vector lean = turned(hand.lean_x, hand.lean_y);
    const Vector width = turned(hand.cos_rotation, hand.sin_rotation);
    const double side = placement.mirrored ? -1.0 : 1.0;
    HandPose result = hand;
    result.x_mm = place.x + placement.x_mm;
    result.y_mm = place.y + placement.y_mm;
    result.travel_x = travel.x;
    result.travel_y = travel.y;
    result.lean_x = lean.x;
    result.lean_y = lean.y;
    result.cos_rotation = side * width.x;
    result.sin_rotation = side * width.y;
    return result;
}

Tip mirrored(Tip tip) {
    for (Bristle& bristle : tip.bristles)
        bristle.root_x_mm = -bristle.root_x_mm;
    for (auto first = tip.hairs.begin(); first != tip.hairs.end(); first += tip.hair_count())
        std::reverse(first, first + tip.hair_count());
    tip.mirrored = !tip.mirrored;
    return tip;
}

}  // namespace pastoso::brush
