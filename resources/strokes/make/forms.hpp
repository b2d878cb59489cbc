// Round things: bodies of revolution seen from the side, and the light on them.
#pragma once

#include "area.hpp"

#include <functional>

namespace pastoso::examples {

/// A body turned about the line from `foot` to `head`; `radius_mm` from 0 at the foot to 1 at the head.
struct Turned {
    Point foot, head;
    std::function<double(double)> radius_mm;
};

/// About the distance to the outline, negative outside.
double depth_mm(const Turned& body, Point at);

/// Along the meridian through a point, towards the foot.
Point meridian(const Turned& body, Point at);

/// Round the body, as a turner's tool would mark it, seen from a little above.
Point parallel(const Turned& body, Point at);

/// How light the surface is, 0 to 1: a light from the upper left and the front, some of it reflected
/// from below.
double light_on(const Turned& body, Point at);

/// The body as an area to be painted along its meridians.
Area area_of(const Turned& body);

}  // namespace pastoso::examples
