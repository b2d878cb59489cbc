#include "interactions/canvas_clip.hpp"

#include "core/units.hpp"

#include <algorithm>
#include <cmath>

namespace pastoso::interactions {

void CanvasClip::add(const glm::dvec2& p, const glm::dvec2& d, double low, double high) {
    for (int axis = 0; axis < 2; ++axis) {
        if (d[axis] == 0.0) {
            if (p[axis] < 0.0 || p[axis] > canvas_mm_[axis]) return;
            continue;
        }
        const double a = -p[axis] / d[axis], b = (canvas_mm_[axis] - p[axis]) / d[axis];
        low = std::max(low, std::min(a, b));
        high = std::min(high, std::max(a, b));
    }
    if (low >= high) return;
    lines_.emplace_back(p + low * d);
    lines_.emplace_back(p + high * d);
}

void CanvasClip::add(const brush::EllipseCurve& ellipse) {
    constexpr int kPieces = 128;
    const double turn = core::radians(ellipse.turn_deg);
    const auto point = [&](int i) {
        const double angle = 2.0 * core::kPi * i / kPieces;
        const double x = ellipse.half_width_mm * std::cos(angle);
        const double y = ellipse.half_height_mm * std::sin(angle);
        return glm::dvec2(ellipse.centre_x_mm + x * std::cos(turn) - y * std::sin(turn),
                          ellipse.centre_y_mm + x * std::sin(turn) + y * std::cos(turn));
    };
    for (int i = 0; i < kPieces; ++i)
        add(point(i), point(i + 1) - point(i), 0.0, 1.0);
}

}  // namespace pastoso::interactions
