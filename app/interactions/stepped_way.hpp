// Ways that Shift keeps level, upright or halfway between.
#pragma once

#include "core/units.hpp"

#include <cmath>

#include <glm/geometric.hpp>
#include <glm/vec2.hpp>

namespace pastoso::interactions {

/// As long, in the nearest of eight directions.
inline glm::dvec2 stepped(const glm::dvec2& way) {
    constexpr double kStep = 0.25 * core::kPi;
    const double angle = kStep * std::round(std::atan2(way.y, way.x) / kStep);
    return glm::length(way) * glm::dvec2(std::cos(angle), std::sin(angle));
}

}  // namespace pastoso::interactions
