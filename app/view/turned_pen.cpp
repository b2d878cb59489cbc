#include "view/turned_pen.hpp"

#include "core/units.hpp"

#include <algorithm>
#include <cmath>

#include <glm/matrix.hpp>

namespace pastoso::view {
namespace {

/// A pen that lies flat has no finite slope.
constexpr double kFlattest_deg = 89.9;

double slope(double tilt_deg) {
    return std::tan(core::radians(std::clamp(tilt_deg, -kFlattest_deg, kFlattest_deg)));
}

double tilt_deg(double slope) {
    return core::degrees(std::atan(slope));
}

/// The direction on the canvas of one on the screen.
double canvas_direction_deg(const screen::ViewTransform& view, double screen_deg) {
    const double turned_back = screen_deg - view.angle_deg;
    return std::remainder(view.mirrored ? 180.0 - turned_back : turned_back, 360.0);
}

}  // namespace

tools::Pointer against_canvas(const screen::ViewTransform& view, tools::Pointer pointer) {
    if (view.angle_deg == 0.0 && !view.mirrored) return pointer;
    // The axis of the pen is (tan tilt_x, tan tilt_y, 1).
    const glm::dvec2 lean =
        glm::transpose(view.axes()) * glm::dvec2(slope(pointer.tilt_x_deg), slope(pointer.tilt_y_deg));
    pointer.tilt_x_deg = tilt_deg(lean.x);
    pointer.tilt_y_deg = tilt_deg(lean.y);
    if (pointer.rotation_deg) pointer.rotation_deg = canvas_direction_deg(view, *pointer.rotation_deg);
    pointer.hand_deg = canvas_direction_deg(view, pointer.hand_deg);
    return pointer;
}

}  // namespace pastoso::view
