#include "paths.hpp"

#include "core/units.hpp"

#include <algorithm>
#include <cmath>

namespace pastoso::examples {
namespace {

constexpr int kArcSteps_per_segment = 24;

}  // namespace

double length(Point vector) {
    return std::hypot(vector.x, vector.y);
}
double dot(Point a, Point b) {
    return a.x * b.x + a.y * b.y;
}

double smooth_step(double a, double b, double t) {
    const double s = std::clamp((t - a) / (b - a), 0.0, 1.0);
    return s * s * (3.0 - 2.0 * s);
}

double pressure_at(const Press& press, double u) {
    return press.level * smooth_step(0.0, press.rise, u) * (1.0 - smooth_step(1.0 - press.fall, 1.0, u));
}

Curve::Curve(std::vector<Point> points) : points_(std::move(points)) {
    const int steps = kArcSteps_per_segment * static_cast<int>(points_.size() - 1);
    arc_.push_back(0.0);
    for (int i = 1; i <= steps; ++i) {
        const Point step = raw(static_cast<double>(i) / kArcSteps_per_segment) -
                           raw(static_cast<double>(i - 1) / kArcSteps_per_segment);
        arc_.push_back(arc_.back() + length(step));
    }
}

Point Curve::raw(double parameter) const {
    const int last = static_cast<int>(points_.size()) - 1;
    const int i = std::clamp(static_cast<int>(parameter), 0, last - 1);
    const double t = parameter - i;
    const Point b = points_[i], c = points_[i + 1];
    const Point a = i > 0 ? points_[i - 1] : 2.0 * b - c;
    const Point d = i + 2 <= last ? points_[i + 2] : 2.0 * c - b;
    return 0.5 * (2.0 * b + t * (c - a) + t * t * (2.0 * a - 5.0 * b + 4.0 * c - d) +
                  t * t * t * (3.0 * b - a - 3.0 * c + d));
}

double Curve::parameter_at(double u) const {
    const double wanted = std::clamp(u, 0.0, 1.0) * length_mm();
    const auto after = std::upper_bound(arc_.begin() + 1, arc_.end() - 1, wanted);
    const double before = after[-1];
    const double share = *after > before ? (wanted - before) / (*after - before) : 0.0;
    return (static_cast<double>(after - arc_.begin() - 1) + share) / kArcSteps_per_segment;
}

Point Curve::at(double u) const {
    return raw(parameter_at(u));
}

Point Curve::direction(double u) const {
    constexpr double kDelta = 1e-3;
    const Point step = at(u + kDelta) - at(u - kDelta);
    return 1.0 / std::max(length(step), 1e-12) * step;
}

void paint_along(Painter& painter, const Curve& curve, double speed_mm_s, const Press& press,
                 double turn_deg) {
    painter.stroke(curve.length_mm() / speed_mm_s, [&](double u) {
        const Point at = curve.at(u), direction = curve.direction(u);
        const double across_deg = core::degrees(std::atan2(direction.y, direction.x)) + 90.0;
        return Touch{at.x, at.y, pressure_at(press, u), across_deg + turn_deg};
    });
}

void paint_held(Painter& painter, const Curve& curve, double speed_mm_s, const Press& press,
                double rotation_deg) {
    painter.stroke(curve.length_mm() / speed_mm_s, [&](double u) {
        const Point at = curve.at(u);
        return Touch{at.x, at.y, pressure_at(press, u), rotation_deg};
    });
}

}  // namespace pastoso::examples
