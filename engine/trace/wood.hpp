// The grain of a table's boards.
#pragma once

#include <glm/vec2.hpp>

namespace pastoso::trace {

/// What the grain makes of a table's reflectance, about 1 in the mean, 0.5 to 1.2: boards along x, year
/// rings that wander, fibres, and the gaps between the boards.
float wood_grain(const glm::vec2& place_m);

}  // namespace pastoso::trace
