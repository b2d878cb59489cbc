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

}  // namespace pastoso::liquid
