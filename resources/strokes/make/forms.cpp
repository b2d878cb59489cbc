#include "forms.hpp"

#include <algorithm>
#include <cmath>

namespace pastoso::examples {
namespace {

/// A point in the body's own terms.
struct Place {
    double along = 0.0;     ///< 0 foot to 1 head
    double aside_mm = 0.0;  ///< from the axis
    Point axis, side;       ///< unit vectors
    double axis_mm = 1.0;
};

Place place_on(const Turned& body, Point at) {
    Place place;
    const Point axis = body.head - body.foot;
    place.axis_mm = length(axis);
    place.axis = 1.0 / place.axis_mm * axis;
    place.side = {-place.axis.y, place.axis.x};
    place.along = dot(at - body.foot, place.axis) / place.axis_mm;
    place.aside_mm = dot(at - body.foot, place.side);
    return place;
}

double radius(const Turned& body, double along) {
    return along < 0.0 || along > 1.0 ? 0.0 : body.radius_mm(along);
}

/// Change of the radius along the axis, mm per mm.
double flare(const Turned& body, const Place& place) {
    constexpr double kDelta = 0.01;
    const double a = std::clamp(place.along, kDelta, 1.0 - kDelta);
    return (radius(body, a + kDelta) - radius(body, a - kDelta)) / (2.0 * kDelta * place.axis_mm);
}

}  // namespace

double depth_mm(const Turned& body, Point at) {
    const Place place = place_on(body, at);
    const double slope = flare(body, place);
    const double aside = (radius(body, place.along) - std::abs(place.aside_mm)) / std::hypot(1.0, slope);
    const double end = std::min(place.along, 1.0 - place.along) * place.axis_mm;
    return end < 0.0 ? end : aside;
}

Point meridian(const Turned& body, Point at) {
    const Place place = place_on(body, at);
    const double share = place.aside_mm / std::max(radius(body, place.along), 1e-6);
    return -1.0 * (place.axis + std::clamp(share * flare(body, place), -1.5, 1.5) * place.side);
}

Point parallel(const Turned& body, Point at) {
    const Place place = place_on(body, at);
    const double share =
        std::clamp(place.aside_mm / std::max(radius(body, place.along), 1e-6), -1.0, 1.0);
    return place.side + 0.45 * share * place.axis;
}

double light_on(const Turned& body, Point at) {
    const Place place = place_on(body, at);
    const double share =
        std::clamp(place.aside_mm / std::max(radius(body, place.along), 1e-6), -0.999, 0.999);
    const double front = std::sqrt(1.0 - share * share);
    const Point across = share * place.side - flare(body, place) * place.axis;
    const double scale = 1.0 / std::hypot(length(across), front);
    const Point normal = scale * across;
    const double key = std::max(0.0, dot(normal, {-0.56, -0.52}) + 0.64 * scale * front);
    const double bounce = std::max(0.0, dot(normal, {0.5, 0.8}) - 0.35);
    return std::clamp(0.06 + 0.92 * key + 0.35 * bounce, 0.0, 1.0);
}

Area area_of(const Turned& body) {
    return {[body](Point at) { return depth_mm(body, at); },
            [body](Point at) { return meridian(body, at); },
            [body](Point at) { return light_on(body, at); }};
}

}  // namespace pastoso::examples
