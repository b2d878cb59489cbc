// The distance from the glass of a cup: a figure in the plane of radius and height that is turned around
// the cup's axis.
#pragma once

#include "liquid/vessel/cup.hpp"

#include <array>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

namespace pastoso::tank {

class GlassDistance {
  public:
    /// A cup that check_shape() accepts.
    explicit GlassDistance(const liquid::Cup& cup);

    /// Exact, negative within the glass.
    float operator()(const glm::vec3& point_m) const;

  private:
    liquid::Cup cup_;
    /// From the middle of the underside around the wall to the middle of the inner floor.
    std::array<glm::vec2, 6> outline_m_;
};

}  // namespace pastoso::tank
