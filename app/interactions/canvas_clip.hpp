// Lines as far as they lie on the canvas.
#pragma once

#include "brush/pen_guide.hpp"

#include <utility>
#include <vector>

#include <glm/vec2.hpp>

namespace pastoso::interactions {

/// So many of its own lengths a line without ends is followed, either way.
inline constexpr double kEndless = 1e6;

/// Gathers what lies on a canvas of a size: every two points are a line, in millimetres.
class CanvasClip {
  public:
    explicit CanvasClip(const glm::dvec2& canvas_mm) : canvas_mm_(canvas_mm) {}

    /// The part of the line p + t d, t in [low, high], that lies on the canvas (Liang and Barsky 1984).
    void add(const glm::dvec2& p, const glm::dvec2& d, double low, double high);

    /// In short pieces.
    void add(const brush::EllipseCurve& ellipse);

    std::vector<glm::vec2> take_lines() { return std::move(lines_); }

  private:
    glm::dvec2 canvas_mm_;
    std::vector<glm::vec2> lines_;
};

}  // namespace pastoso::interactions
