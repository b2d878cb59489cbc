// Draws over a picture that the processor has made.
#pragma once

#include "screen/overlay_painter.hpp"

#include <QPen>

namespace pastoso::screen {

/// Draws with a painter in points of the layout, of so many device pixels.
class RasterOverlay : public OverlayPainter {
  public:
    RasterOverlay(QPainter& painter, double point_px) : painter_(painter), point_px_(point_px) {}

    void draw_loop(const std::vector<glm::vec2>& points_mm, const OverlayFrame& frame,
                   float strength) override;
    void draw_segments(const std::vector<glm::vec2>& points_mm, const OverlayFrame& frame,
                       float strength) override;
    void draw_dashes(const std::vector<glm::vec2>& points_mm, const OverlayFrame& frame) override;
    void draw(const std::function<void(QPainter&)>& drawing) override;

  private:
    template <class Lines>
    void draw_twice(float strength, const Lines& lines);
    QPen pen(const QColor& colour) const;

    QPainter& painter_;
    double point_px_;
};

}  // namespace pastoso::screen
