#include "layers/projective.hpp"

#include "core/check.hpp"
#include "core/units.hpp"

#include <algorithm>
#include <cmath>

namespace pastoso::layers {
namespace {

using grid::Point;

/// A parallelogram's corners are known so well; what is less of a perspective is rounding.
constexpr double kRounding = 1e-12;

double cross(const Point& from, const Point& at, const Point& to) {
    return (at.x - from.x) * (to.y - at.y) - (at.y - from.y) * (to.x - at.x);
}

double dot(const Point& from, const Point& at, const Point& to) {
    return (at.x - from.x) * (to.x - at.x) + (at.y - from.y) * (to.y - at.y);
}

/// How far a line that comes along one side turns into the next, clockwise.
double bend_deg(const Point& from, const Point& at, const Point& to) {
    return core::degrees(std::atan2(cross(from, at, to), dot(from, at, to)));
}

double longest_side(const Corners& p) {
    double longest = 0.0;
    for (std::size_t k = 0; k < p.size(); ++k)
        longest = std::max(longest, std::hypot(p[(k + 1) % 4].x - p[k].x, p[(k + 1) % 4].y - p[k].y));
    return longest;
}

/// Of the square from (0, 0) to (1, 1).
Projective of_unit_square(const Corners& p) {
    const double sum_x = p[0].x - p[1].x + p[2].x - p[3].x, sum_y = p[0].y - p[1].y + p[2].y - p[3].y;
    const double far = kRounding * longest_side(p);
    if (std::abs(sum_x) <= far && std::abs(sum_y) <= far)
        return {p[1].x - p[0].x, p[3].x - p[0].x, p[0].x, p[1].y - p[0].y, p[3].y - p[0].y, p[0].y};
    const Point one{p[1].x - p[2].x, p[1].y - p[2].y}, other{p[3].x - p[2].x, p[3].y - p[2].y};
    const double determinant = one.x * other.y - other.x * one.y;
    const double g = (sum_x * other.y - other.x * sum_y) / determinant;
    const double h = (one.x * sum_y - sum_x * one.y) / determinant;
    return {p[1].x - p[0].x + g * p[1].x,
            p[3].x - p[0].x + h * p[3].x,
            p[0].x,
            p[1].y - p[0].y + g * p[1].y,
            p[3].y - p[0].y + h * p[3].y,
            p[0].y,
            g,
            h,
            1.0};
}

Projective scaled(const Projective& map, double by) {
    return {by * map.a, by * map.b, by * map.c, by * map.d, by * map.e,
            by * map.f, by * map.g, by * map.h, by * map.i};
}

/// The depth is 1 everywhere, unrounded.
Projective affine_inverse(const Projective& map) {
    const double determinant = map.a * map.e - map.b * map.d;
    PASTOSO_CHECK(determinant != 0.0);
    const double scale = 1.0 / determinant;
    const Projective turned{scale * map.e, -scale * map.b, 0.0, -scale * map.d, scale * map.a, 0.0};
    const Point shift = turned(map.c, map.f);
    return {turned.a, turned.b, -shift.x, turned.d, turned.e, -shift.y};
}

}  // namespace

Steps steps_at(const Projective& map, double x, double y) {
    const double depth = map.depth(x, y);
    const Point there = map(x, y);
    return {{(map.a - there.x * map.g) / depth, (map.d - there.y * map.g) / depth},
            {(map.b - there.x * map.h) / depth, (map.e - there.y * map.h) / depth}};
}

Projective followed_by(const Projective& first, const Projective& then) {
    const auto& [a, b, c, d, e, f, g, h, i] = then;
    const Projective& p = first;
    return {a * p.a + b * p.d + c * p.g, a * p.b + b * p.e + c * p.h, a * p.c + b * p.f + c * p.i,
            d * p.a + e * p.d + f * p.g, d * p.b + e * p.e + f * p.h, d * p.c + e * p.f + f * p.i,
            g * p.a + h * p.d + i * p.g, g * p.b + h * p.e + i * p.h, g * p.c + h * p.f + i * p.i};
}

Projective turn_by(double angle_deg) {
    const double angle = core::radians(angle_deg);
    const double cosine = std::cos(angle), sine = std::sin(angle);
    return {cosine, -sine, 0.0, sine, cosine, 0.0};
}

Projective inverse(const Projective& map) {
    if (map.is_affine()) return affine_inverse(map);
    const auto& [a, b, c, d, e, f, g, h, i] = map;
    const double determinant = a * (e * i - f * h) - b * (d * i - f * g) + c * (d * h - e * g);
    PASTOSO_CHECK(determinant != 0.0);
    const Projective adjugate{e * i - f * h, c * h - b * i, b * f - c * e, f * g - d * i, a * i - c * g,
                              c * d - a * f, d * h - e * g, b * g - a * h, a * e - b * d};
    return scaled(adjugate, 1.0 / determinant);
}

Projective onto_corners(const Point& corner, double width, double height, const Corners& corners) {
    const Projective square = of_unit_square(corners);
    const Projective into_square{1.0 / width, 0.0,          -corner.x / width,
                                 0.0,         1.0 / height, -corner.y / height};
    const Projective map = followed_by(into_square, square);
    if (square.is_affine()) return map;
    const double farthest = std::max({1.0, 1.0 + square.g, 1.0 + square.h, 1.0 + square.g + square.h});
    return scaled(map, 1.0 / farthest);
}

bool bends_outwards(const Corners& corners) {
    double least_deg = 360.0, most_deg = -360.0;
    for (std::size_t k = 0; k < corners.size(); ++k) {
        const double bend = bend_deg(corners[k], corners[(k + 1) % 4], corners[(k + 2) % 4]);
        least_deg = std::min(least_deg, bend);
        most_deg = std::max(most_deg, bend);
    }
    return least_deg >= kLeastBend_deg || most_deg <= -kLeastBend_deg;
}

}  // namespace pastoso::layers
