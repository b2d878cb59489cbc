// The outline of the brush's tip around the pointer.
#pragma once

#include <vector>

#include <glm/vec2.hpp>

namespace pastoso::view {

/// The tip's footprint on the canvas: an ellipse, or a rectangle with round corners.
struct TipShape {
    double width_mm = 20.0;
    double thickness_mm = 5.0;
    double rotation_deg = 0.0;  ///< of the width's direction, clockwise on the canvas
    bool angular = true;
    friend bool operator==(const TipShape&, const TipShape&) = default;
};

/// A closed line around the shape, relative to its centre.
std::vector<glm::vec2> outline_mm(const TipShape& shape);

}  // namespace pastoso::view
