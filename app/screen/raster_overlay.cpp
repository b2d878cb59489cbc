#include "screen/raster_overlay.hpp"

#include <QPainter>
#include <QPolygonF>

namespace pastoso::screen {
namespace {

QPolygonF in_points(const std::vector<glm::vec2>& points_mm, const OverlayFrame& frame,
                    double point_px) {
    QPolygonF points;
    for (const glm::vec2& mm : points_mm) {
        const glm::dvec2 px = frame.device_px(mm);
        points << QPointF(px.x, px.y) / point_px;
    }
    return points;
}

/// A line for every two points.
void draw_pairs(QPainter& painter, const QPolygonF& points) {
    for (int i = 0; i + 1 < points.size(); i += 2)
        painter.drawLine(points[i], points[i + 1]);
}

}  // namespace

QPen RasterOverlay::pen(const QColor& colour) const {
    return QPen(colour, 1.0 / point_px_);
}

template <class Lines>
void RasterOverlay::draw_twice(float strength, const Lines& lines) {
    painter_.save();
    painter_.setRenderHint(QPainter::Antialiasing);
    painter_.setBrush(Qt::NoBrush);
    painter_.translate(QPointF(1.0, 1.0) / point_px_);
    painter_.setPen(pen(QColor::fromRgbF(0.0F, 0.0F, 0.0F, 0.55F * strength)));
    lines();
    painter_.translate(QPointF(-1.0, -1.0) / point_px_);
    painter_.setPen(pen(QColor::fromRgbF(1.0F, 1.0F, 1.0F, 0.75F * strength)));
    lines();
    painter_.restore();
}

void RasterOverlay::draw_loop(const std::vector<glm::vec2>& points_mm, const OverlayFrame& frame,
                              float strength) {
    const QPolygonF points = in_points(points_mm, frame, point_px_);
    draw_twice(strength, [&] { painter_.drawPolygon(points); });
}

void RasterOverlay::draw_segments(const std::vector<glm::vec2>& points_mm, const OverlayFrame& frame,
                                  float strength) {
    const QPolygonF points = in_points(points_mm, frame, point_px_);
    draw_twice(strength, [&] { draw_pairs(painter_, points); });
}

void RasterOverlay::draw_dashes(const std::vector<glm::vec2>& points_mm, const OverlayFrame& frame) {
    constexpr double kDash_px = 4.0;
    const QPolygonF points = in_points(points_mm, frame, point_px_);
    painter_.save();
    painter_.setPen(pen(Qt::white));
    draw_pairs(painter_, points);
    QPen dashes = pen(Qt::black);
    dashes.setDashPattern({kDash_px, kDash_px});
    painter_.setPen(dashes);
    draw_pairs(painter_, points);
    painter_.restore();
}

void RasterOverlay::draw(const std::function<void(QPainter&)>& drawing) {
    painter_.save();
    drawing(painter_);
    painter_.restore();
}

}  // namespace pastoso::screen
