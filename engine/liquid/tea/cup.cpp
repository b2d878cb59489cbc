#include "liquid/tea/cup.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <glm/geometric.hpp>

namespace pastoso::liquid {

float tea_distance_m(const Cup& cup, const glm::vec3& point_m) {
    const float radius = glm::length(glm::vec2(point_m) - cup.axis_m);
    const float wall =
        (radius - cup.inner_radius_m(point_m.z)) / std::sqrt(1.0F + cup.slope * cup.slope);
    return std::max({wall, cup.floor_m - point_m.z, point_m.z - cup.level_m});
}

glm::vec3 pushed_within(const Cup& cup, glm::vec3 point_m, float margin_m) {
    constexpr int kPushes = 3;  // one for wall, floor and level each
    const float step_m = 0.5F * margin_m;
    const auto distance = [&](const glm::vec3& at_m) { return tea_distance_m(cup, at_m) + margin_m; };
    for (int push = 0; push < kPushes && distance(point_m) > 0.0F; ++push) {
        glm::vec3 normal;
        for (const int axis : {0, 1, 2}) {
            glm::vec3 aside(0.0F);
            aside[axis] = step_m;
            normal[axis] = distance(point_m + aside) - distance(point_m - aside);
        }
        const float length = glm::length(normal);
        if (length > 0.0F) point_m -= normal * (distance(point_m) / length);
    }
    return point_m;
}

double tea_volume_m3(const Cup& cup) {
    const double low = cup.floor_radius_m, high = cup.inner_radius_m(cup.level_m);
    return std::numbers::pi / 3.0 *
           (static_cast<double>(cup.level_m) - static_cast<double>(cup.floor_m)) *
           (low * low + low * high + high * high);
}

/// By Newton's method from the cup's level: a cone's volume is smooth, and its areas are its slope.
float level_at_volume_m(const Cup& cup, double volume_m3) {
    constexpr int kRounds = 8;
    Cup filled = cup;
    for (int round = 0; round < kRounds; ++round) {
        const double radius_m = filled.inner_radius_m(filled.level_m);
        const double missing_m3 = volume_m3 - tea_volume_m3(filled);
        const double rise_m = missing_m3 / (std::numbers::pi * radius_m * radius_m);
        filled.level_m = std::max(static_cast<float>(filled.level_m + rise_m), cup.floor_m);
    }
    return filled.level_m;
}

}  // namespace pastoso::liquid
