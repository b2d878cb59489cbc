#include "liquid/cup.hpp"

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

double tea_volume_m3(const Cup& cup) {
    const double low = cup.floor_radius_m, high = cup.inner_radius_m(cup.level_m);
    return std::numbers::pi / 3.0 *
           (static_cast<double>(cup.level_m) - static_cast<double>(cup.floor_m)) *
           (low * low + low * high + high * high);
}

}  // namespace pastoso::liquid
