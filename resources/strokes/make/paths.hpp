// The paths that strokes follow.
#pragma once

#include "painter.hpp"

#include <functional>
#include <vector>

namespace pastoso::examples {

struct Point {
    double x = 0.0, y = 0.0;
    friend Point operator+(Point a, Point b) { return {a.x + b.x, a.y + b.y}; }
    friend Point operator-(Point a, Point b) { return {a.x - b.x, a.y - b.y}; }
    friend Point operator*(double s, Point a) { return {s * a.x, s * a.y}; }
};
double length(Point vector);
double dot(Point a, Point b);

/// Rises smoothly from 0 to 1 between a and b.
double smooth_step(double a, double b, double t);

/// How a stroke is pressed: up to `level` over the share `rise` of its length, down again over `fall`.
struct Press {
    double level = 0.4;
    double rise = 0.1;
    double fall = 0.15;
};
double pressure_at(const Press& press, double u);

/// A smooth curve through points, from the first at u = 0 to the last at u = 1, evenly fast
/// (Catmull-Rom).
class Curve {
  public:
    explicit Curve(std::vector<Point> points);
    Point at(double u) const;
    Point direction(double u) const;  ///< unit length
    double length_mm() const { return arc_.back(); }

  private:
    Point raw(double parameter) const;
    double parameter_at(double u) const;

    std::vector<Point> points_;
    std::vector<double> arc_;  ///< length up to equal steps of the parameter
};

/// Paints along a curve with the width of the tip across it, turned by `turn_deg` from there.
void paint_along(Painter& painter, const Curve& curve, double speed_mm_s, const Press& press,
                 double turn_deg = 0.0);

/// Paints along a curve with the barrel held still.
void paint_held(Painter& painter, const Curve& curve, double speed_mm_s, const Press& press,
                double rotation_deg);

}  // namespace pastoso::examples
