#include "tools/mirrors.hpp"

#include <cmath>

namespace pastoso::tools {
namespace {

constexpr double kRightAngle_deg = 90.0;

/// Whether the mirror's axis is nearer to upright than to level.
bool stands(const brush::Symmetry& symmetry) {
    return std::abs(std::remainder(symmetry.axis_deg - kRightAngle_deg, 180.0)) <= 45.0;
}

/// The direction of a line that runs both ways: 0 to below 180.
double line_deg(double angle_deg) {
    return angle_deg - 180.0 * std::floor(angle_deg / 180.0);
}

}  // namespace

Mirrors mirrors_of(const brush::Symmetry& symmetry) {
    if (!symmetry.mirror) return {};
    const bool both = symmetry.count % 2 == 0;
    return {both || stands(symmetry), both || !stands(symmetry)};
}

brush::Symmetry with_mirrors(brush::Symmetry symmetry, const Mirrors& wanted) {
    const Mirrors before = mirrors_of(symmetry);
    if (wanted == before) return symmetry;
    if (symmetry.count > 2) {
        symmetry.mirror = !symmetry.mirror;
        return symmetry;
    }
    const bool turns = stands(symmetry) ? !wanted.upright && wanted.level : wanted.upright;
    const bool crossed = before.upright && before.level;
    symmetry.mirror = wanted.upright || wanted.level;
    if (wanted.upright && wanted.level)
        symmetry.count = 2;
    else if (crossed)
        symmetry.count = 1;
    if (turns) symmetry.axis_deg = line_deg(symmetry.axis_deg + kRightAngle_deg);
    return symmetry;
}

}  // namespace pastoso::tools
