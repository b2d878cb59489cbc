// Vessels and velocities that several tests of the flow share.
#pragma once

#include "liquid/flow/walls.hpp"
#include "liquid/vessel/cup.hpp"

namespace pastoso::liquid::cases {

/// A cube of side 0.1 m around the default cup.
inline grid::BoxShape cup_box(int cells) {
    return {cells, cells, cells, 0.1F / static_cast<float>(cells)};
}
inline SignedDistance cup_distance(const Cup& cup = {}) {
    return [cup](const glm::vec3& point_m) { return tea_distance_m(cup, point_m); };
}
inline float no_walls(const glm::vec3&) {
    return -1.0F;
}

/// Values spread evenly over -1 to 1, everywhere.
void fill_randomly(grid::BoxField& field, unsigned seed);
VelocityField random_velocity(const grid::BoxShape& shape, unsigned seed);

/// The largest |a - b| of all samples, ghosts among them.
float largest_difference(const grid::BoxField& a, const grid::BoxField& b);

}  // namespace pastoso::liquid::cases
