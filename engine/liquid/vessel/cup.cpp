#include "liquid/vessel/cup.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <glm/geometric.hpp>

namespace pastoso::liquid {

namespace {

/// The edges of a cup's tea, for distances of many points.
struct TeaEdges {
    const Cup& cup;
    float wall_normal = std::sqrt(1.0F + cup.slope * cup.slope);  ///< length of (1, slope)

    float radius_m(const glm::vec2& place_m) const { return glm::length(place_m - cup.axis_m); }
    /// Of a point so far from the axis.
    float distance_m(float radius_m, float z_m) const {
        const float wall = (radius_m - cup.inner_radius_m(z_m)) / wall_normal;
        return std::max({wall, cup.floor_m - z_m, z_m - cup.level_m});
    }
};

}  // namespace

float tea_distance_m(const Cup& cup, const glm::vec3& point_m) {
    const TeaEdges edges{cup};
    return edges.distance_m(edges.radius_m(point_m), point_m.z);
}

glm::vec3 pushed_within(const Cup& cup, glm::vec3 point_m, float margin_m) {
    constexpr int kPushes = 3;  // one for wall, floor and level each
    const float step_m = 0.5F * margin_m;
    const TeaEdges edges{cup};
    const auto distance = [&](float radius_m, float z_m) {
        return edges.distance_m(radius_m, z_m) + margin_m;
    };
    for (int push = 0; push < kPushes; ++push) {
        const glm::vec2 place_m = point_m;
        const float radius_m = edges.radius_m(place_m), z_m = point_m.z;
        const float outside_m = distance(radius_m, z_m);
        if (!(outside_m > 0.0F)) break;
        const auto across = [&](const glm::vec2& aside_m) {
            return distance(edges.radius_m(place_m + aside_m), z_m) -
                   distance(edges.radius_m(place_m - aside_m), z_m);
        };
        const glm::vec3 normal(across({step_m, 0.0F}), across({0.0F, step_m}),
                               distance(radius_m, z_m + step_m) - distance(radius_m, z_m - step_m));
        const float length = glm::length(normal);
        if (length > 0.0F) point_m -= normal * (outside_m / length);
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
