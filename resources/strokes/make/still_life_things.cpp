#include "still_life_things.hpp"

#include "core/units.hpp"

#include <algorithm>
#include <cmath>

namespace pastoso::examples {
namespace {

/// From a round belly to a narrow neck; the power makes a smooth maximum of the two.
double pear_radius(double along, double widest_mm) {
    const double belly = std::sqrt(std::max(0.0, 1.0 - std::pow((along - 0.35) / 0.355, 2)));
    const double neck = 0.46 * std::sqrt(std::max(0.0, 1.0 - std::pow((along - 0.72) / 0.28, 2)));
    return widest_mm * std::pow(std::pow(belly, 5) + std::pow(neck, 5), 0.2);
}

Turned pear(Point foot, Point head, double widest_mm) {
    return {foot, head, [widest_mm](double along) { return pear_radius(along, widest_mm); }};
}

/// An ellipsoid, drawn out at both ends by `point`.
Turned ball(Point foot, Point head, double widest_mm, double point = 0.0) {
    return {foot, head, [=](double along) {
                const double round = std::sqrt(std::max(0.0, 1.0 - std::pow(2.0 * along - 1.0, 2)));
                return widest_mm * std::pow(round, 1.0 + point);
            }};
}

double bowl_radius(double along) {
    return 17.0 + 22.5 * std::pow(along, 0.62);
}

double ellipse_depth_mm(Point centre, double half_width, double half_height, double turn_deg, Point at) {
    const double c = std::cos(core::radians(turn_deg)), s = std::sin(core::radians(turn_deg));
    const Point from = at - centre;
    const Point local{c * from.x + s * from.y, -s * from.x + c * from.y};
    return (1.0 - std::hypot(local.x / half_width, local.y / half_height)) *
           std::min(half_width, half_height);
}

}  // namespace

const Turned kGreenPear = pear({84, 74}, {79, 26}, 15.5);
const Turned kRipePear = pear({114, 75}, {124, 30}, 14.5);
const Turned kLemon = ball({24, 99}, {60, 91}, 11.5, 0.25);
const Turned kApple = ball({143, 108}, {142, 82}, 13.8);
const Turned kBowl{{99, 101}, {99, 66}, bowl_radius};

namespace {

/// Everything that stands before wall and cloth.
double things_depth_mm(Point at) {
    return std::max({depth_mm(kGreenPear, at), depth_mm(kRipePear, at), depth_mm(kLemon, at),
                     depth_mm(kApple, at), depth_mm(kBowl, at), opening_depth_mm(at)});
}

}  // namespace

double opening_depth_mm(Point at) {
    return ellipse_depth_mm(kRim, kRimHalfWidth_mm, kRimHalfHeight_mm, 0.0, at);
}

double bowl_depth_mm(Point at) {
    const double x = (at.x - kRim.x) / kRimHalfWidth_mm;
    const double edge_y = kRim.y + kRimHalfHeight_mm * std::sqrt(std::max(0.0, 1.0 - x * x));
    return std::min(depth_mm(kBowl, at), at.y - edge_y);
}

double free_of_things_mm(Point at) {
    return kTuckedUnder_mm - things_depth_mm(at);
}

double canvas_depth_mm(Point at) {
    constexpr double kBeyond_mm = 14.0;
    return kBeyond_mm + std::min({at.x, kStillLifeWidth_mm - at.x, at.y, kStillLifeHeight_mm - at.y});
}

double table_edge_y(double x) {
    return 71.0 - 0.02 * x;
}

double cast_shadow_depth_mm(Point at) {
    return std::max({ellipse_depth_mm({59, 102.5}, 22, 6.0, 6, at),
                     ellipse_depth_mm({124, 101.5}, 30, 7.0, 3, at),
                     ellipse_depth_mm({158, 106}, 17, 5.5, 4, at)});
}

}  // namespace pastoso::examples
