// Surfaces that a profile sweeps over as it turns around an upright axis.
#pragma once

#include "liquid/surface/triangle_mesh.hpp"

#include <span>

#include <glm/vec2.hpp>

namespace pastoso::liquid {

/// A point of a profile, and the unit normal there: away from the axis, and up.
struct TurnedPoint {
    float radius_m = 0.0F;  ///< 0 and more
    float z_m = 0.0F;
    glm::vec2 normal{1.0F, 0.0F};
};

/// Adds the surface between each two successive points, of `segments` >= 3 pieces around the axis. Its
/// outside lies on the right hand of the way along the profile, where the radius points to the right.
void add_turned(const glm::vec2& axis_m, std::span<const TurnedPoint> profile, int segments,
                TriangleMesh& mesh);

}  // namespace pastoso::liquid
