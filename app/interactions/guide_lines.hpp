// Where the guides lie on the canvas, as lines to be drawn.
#pragma once

#include "tools/hand.hpp"

#include <vector>

#include <glm/vec2.hpp>

namespace pastoso::interactions {

/// Every two points are a line, in millimetres, ending at the canvas's edges: the mirror's axes, or
/// without a mirror the rays that part the copies; the ruler; the ellipse in short pieces; the horizon
/// of a perspective. Empty without any of these.
std::vector<glm::vec2> guide_lines_mm(const tools::Hand& hand, const glm::dvec2& canvas_mm);

}  // namespace pastoso::interactions
