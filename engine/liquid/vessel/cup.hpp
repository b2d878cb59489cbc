// The glass that the tea stands in: a cone with a flat floor around an upright axis, in metres, z up.
#pragma once

#include <cmath>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

namespace pastoso::liquid {

struct Cup {
    glm::vec2 axis_m{0.05F, 0.05F};  ///< where the axis stands
    float floor_m = 0.004F;          ///< height of the inner floor
    float floor_radius_m = 0.033F;   ///< inner radius there
    float slope = 0.1F;              ///< the inner radius is floor_radius + slope (z - floor)
    float level_m = 0.088F;          ///< height of the tea's surface
    float wall_m = 0.0022F;          ///< thickness of the glass, measured level
    float foot_m = -0.0015F;         ///< height of the glass' underside
    float rim_m = 0.098F;            ///< height of its rim

    float inner_radius_m(float z_m) const { return floor_radius_m + slope * (z_m - floor_m); }
    friend bool operator==(const Cup&, const Cup&) = default;
};

/// The cup, filled up to another level.
inline Cup filled_to(Cup cup, float level_m) {
    cup.level_m = level_m;
    return cup;
}

/// The cup as a flow in such cells has it: filled up to the middles of its level's cells, so that walls
/// are not found anew for every rise.
inline Cup filled_in_cells(const Cup& cup, float cell_m) {
    return filled_to(cup, cell_m * (std::floor(cup.level_m / cell_m) + 0.5F));
}

/// The signed distance from the surface of the tea at rest, up to the level, negative within; beyond its
/// edges a lower bound of the distance.
float tea_distance_m(const Cup& cup, const glm::vec3& point_m);

/// Whether a point is surely at least `margin_m` (> 0) within the tea; without a square root.
inline bool lies_within(const Cup& cup, const glm::vec3& point_m, float margin_m) {
    const glm::vec2 aside = glm::vec2(point_m) - cup.axis_m;
    // (1 + |slope|) is more than the length of the wall's normal (1, slope).
    const float wall_m =
        cup.inner_radius_m(point_m.z) - margin_m * (1.0F + (cup.slope < 0.0F ? -cup.slope : cup.slope));
    return point_m.z > cup.floor_m + margin_m && point_m.z < cup.level_m - margin_m && wall_m > 0.0F &&
           aside.x * aside.x + aside.y * aside.y < wall_m * wall_m;
}
/// The point of brought_within() where it does not lie within.
glm::vec3 pushed_within(const Cup& cup, glm::vec3 point_m, float margin_m);

/// A point that is not at least `margin_m` (> 0) within the tea, pushed along its wall's normal
/// until it is; one in a corner between wall, floor and level may end a little less within.
inline glm::vec3 brought_within(const Cup& cup, const glm::vec3& point_m, float margin_m) {
    return lies_within(cup, point_m, margin_m) ? point_m : pushed_within(cup, point_m, margin_m);
}

/// The volume of tea and milk up to the level: a frustum of a cone.
double tea_volume_m3(const Cup& cup);
/// The level up to which a volume (>= 0) fills the cup.
float level_at_volume_m(const Cup& cup, double volume_m3);

}  // namespace pastoso::liquid
