// The guides that a painter chooses among, and how each is laid on the canvas at first.
#pragma once

#include "brush/pen_guide.hpp"

#include <glm/vec2.hpp>

namespace pastoso::tools {

/// The parallel ruler and the concentric ellipse are a ruler and an ellipse without reach: no stroke is
/// taken to their edge, each keeps its own distance.
enum class GuideKind {
    None,
    Ruler,
    ParallelRuler,
    Ellipse,
    ConcentricEllipse,
    OnePoint,
    TwoPoints,
    ThreePoints,
    Grid
};

/// Of a guide that may lie on the canvas.
GuideKind kind_of(const brush::PenGuide& guide);

/// The same guide as one of another kind, where it was, as strong; one that has nothing to do with it is
/// laid about the middle of a canvas of that size.
brush::PenGuide as_kind(const brush::PenGuide& guide, GuideKind kind, const glm::dvec2& canvas_mm);

/// The horizon goes through the first two of several points, and uprights stand square on it; of points
/// in one place it stays as it was.
brush::VanishingPoints with_horizon(brush::VanishingPoints points);

}  // namespace pastoso::tools
