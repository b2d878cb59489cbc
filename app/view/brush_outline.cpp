#include "view/brush_outline.hpp"

#include "core/units.hpp"

#include <cmath>

namespace pastoso::view {
namespace {

constexpr int kPoints = 96;

/// Exponent of the superellipse: 2 is an ellipse, 6 a rectangle with round corners.
constexpr double kRound = 2.0;
constexpr double kAngular = 6.0;

double signed_power(double value, double exponent) {
    return std::copysign(std::pow(std::abs(value), exponent), value);
}

}  // namespace

std::vector<glm::vec2> outline_mm(const TipShape& shape) {
    const double exponent = 2.0 / (shape.angular ? kAngular : kRound);
    const double turn = core::radians(shape.rotation_deg);
    std::vector<glm::vec2> points;
    points.reserve(kPoints);
    for (int i = 0; i < kPoints; ++i) {
        const double angle = 2.0 * core::kPi * i / kPoints;
        const double x = 0.5 * shape.width_mm * signed_power(std::cos(angle), exponent);
        const double y = 0.5 * shape.thickness_mm * signed_power(std::sin(angle), exponent);
        points.emplace_back(x * std::cos(turn) - y * std::sin(turn),
                            x * std::sin(turn) + y * std::cos(turn));
    }
    return points;
}

}  // namespace pastoso::view
