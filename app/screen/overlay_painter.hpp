// Draws over the picture of a canvas, on the graphics card or not.
#pragma once

#include <functional>
#include <vector>

#include <QSize>
#include <glm/mat2x2.hpp>
#include <glm/vec2.hpp>

class QPainter;

namespace pastoso::screen {

/// Where millimetres lie in the window.
struct OverlayFrame {
    glm::dvec2 origin_px{};  ///< of the millimetres, in device pixels, y down
    glm::dmat2 px_from_mm{1.0};
    QSize window_px;

    glm::dvec2 device_px(const glm::dvec2& place_mm) const { return origin_px + px_from_mm * place_mm; }
};

/// Lines are dark and light side by side, seen on any paint.
class OverlayPainter {
  public:
    virtual ~OverlayPainter() = default;

    /// A closed line through the points, or a line for every two. `strength` 1 is an outline that has to
    /// be seen, less is fainter.
    virtual void draw_loop(const std::vector<glm::vec2>& points_mm, const OverlayFrame& frame,
                           float strength) = 0;
    virtual void draw_segments(const std::vector<glm::vec2>& points_mm, const OverlayFrame& frame,
                               float strength) = 0;

    /// A line for every two points, along the millimetres' axes, dark and light in turn.
    virtual void draw_dashes(const std::vector<glm::vec2>& points_mm, const OverlayFrame& frame) = 0;

    /// All else, in points of the layout.
    virtual void draw(const std::function<void(QPainter&)>& drawing) = 0;
};

}  // namespace pastoso::screen
