// Some of the ways that strokes take where a guide has many of them.
#pragma once

#include "brush/pen_guide.hpp"

#include <vector>

#include <glm/vec2.hpp>

namespace pastoso::interactions {

/// Every two points are a line, in millimetres, ending at the canvas's edges: the lines of a grid (of
/// more than a hundred in one direction every so many), some of those that meet in vanishing points,
/// some beside a parallel ruler, and ellipses about that of a concentric one.
std::vector<glm::vec2> ways_mm(const brush::PenGuide& guide, const glm::dvec2& canvas_mm);

}  // namespace pastoso::interactions
