// Maps of the plane that take straight lines to straight lines.
#pragma once

#include "grid/mask.hpp"

#include <array>

namespace pastoso::layers {

/// (x, y) -> (a x + b y + c, d x + e y + f) / depth, depth = g x + h y + i. With g = h = 0 and i = 1 it
/// is affine: moves, turns, scales and shears.
struct Projective {
    double a = 1.0, b = 0.0, c = 0.0;
    double d = 0.0, e = 1.0, f = 0.0;
    double g = 0.0, h = 0.0, i = 1.0;

    double depth(double x, double y) const { return g * x + h * y + i; }
    bool is_affine() const { return g == 0.0 && h == 0.0 && i == 1.0; }
    /// At a depth that is not 0.
    grid::Point operator()(double x, double y) const {
        const double far = depth(x, y);
        return {(a * x + b * y + c) / far, (d * x + e * y + f) / far};
    }
};

/// What the map makes of short steps about a place, each times its length.
struct Steps {
    grid::Point right, down;
};
Steps steps_at(const Projective& map, double x, double y);

Projective followed_by(const Projective& first, const Projective& then);

/// Clockwise about the origin, as the canvas is seen (x right, y down).
Projective turn_by(double angle_deg);

/// The other way round. Its depth is 1 / depth at the place that it comes from. The determinant is not
/// 0.
Projective inverse(const Projective& map);

/// Clockwise, from the upper left one of a rectangle.
using Corners = std::array<grid::Point, 4>;

/// The one map that takes the corner (x, y), (x + width, y), (x + width, y + height) and (x, y + height)
/// to the corners. Its depth is 1 in the corner that comes to lie farthest and less elsewhere in the
/// rectangle. (P. S. Heckbert, Fundamentals of Texture Mapping and Image Warping, 1989, 2.2.3.) Needs
/// bends_outwards(corners); width and height are not 0.
Projective onto_corners(const grid::Point& corner, double width, double height, const Corners& corners);

/// Whether a closed line through the corners bends the same way at each, by at least kLeastBend_deg, and
/// does not cross itself.
bool bends_outwards(const Corners& corners);
inline constexpr double kLeastBend_deg = 1.0;

}  // namespace pastoso::layers
