#include "tools/heading.hpp"

#include "core/units.hpp"

#include <cmath>

namespace pastoso::tools {
namespace {

/// The way over which an old direction fades: about half a brush's width, short enough to follow a curve
/// and long enough to be steady.
constexpr double kMemory_mm = 9.0;

/// Shorter movements gather until they have a direction of their own.
constexpr double kShortest_mm = 0.4;

}  // namespace

void Heading::moved_to(double x_mm, double y_mm) {
    if (!started_) {
        started_ = true;
        x_mm_ = x_mm;
        y_mm_ = y_mm;
        return;
    }
    const double dx = x_mm - x_mm_;
    const double dy = y_mm - y_mm_;
    const double way_mm = std::hypot(dx, dy);
    if (way_mm < kShortest_mm) return;
    const double share = 1.0 - std::exp(-way_mm / kMemory_mm);
    const double doubled = 2.0 * std::atan2(dy, dx);
    axis_x_ += share * (std::cos(doubled) - axis_x_);
    axis_y_ += share * (std::sin(doubled) - axis_y_);
    x_mm_ = x_mm;
    y_mm_ = y_mm;
    turn_to_axis();
}

void Heading::stand_across(double dx_mm, double dy_mm) {
    const double doubled = 2.0 * std::atan2(dy_mm, dx_mm);
    axis_x_ = std::cos(doubled);
    axis_y_ = std::sin(doubled);
    turn_to_axis();
}

void Heading::turn_to_axis() {
    const double across_deg = 0.5 * core::degrees(std::atan2(axis_y_, axis_x_)) - 90.0;
    const double turned_deg = rotation_deg_ + std::remainder(across_deg - rotation_deg_, 180.0);
    rotation_deg_ = std::remainder(turned_deg, 360.0);
}

}  // namespace pastoso::tools
