// The value of a field or a velocity at a point, outside the hot loops.
#pragma once

#include "liquid/flow/advection_view.hpp"
#include "liquid/flow/velocity.hpp"

#include <glm/vec3.hpp>

namespace pastoso::liquid {

/// A point in metres within the box, or on its edge; others are put onto the edge. The field's samples
/// around the box must be known.
float sample(const grid::BoxField& field, Location location, const glm::vec3& point_m,
             Interpolation interpolation);

/// In m/s.
glm::vec3 velocity_at(const VelocityField& velocity, const glm::vec3& point_m,
                      Interpolation interpolation);

}  // namespace pastoso::liquid
