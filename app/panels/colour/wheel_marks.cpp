#include "panels/colour/wheel_marks.hpp"

#include "appearance/screen_colours.hpp"

#include <QPainter>
#include <QPainterPath>
#include <QPolygonF>

namespace pastoso::panels {
namespace {

constexpr double kMark_px = 5.0;

const QColor kDark(20, 20, 22), kLight(240, 240, 240);

}  // namespace

void paint_mark(QPainter& painter, const QPointF& place, const QColor& colour) {
    painter.setBrush(appearance::shown(colour));
    painter.setPen(QPen(kDark, 3.0));
    painter.drawEllipse(place, kMark_px, kMark_px);
    painter.setPen(QPen(kLight, 1.5));
    painter.drawEllipse(place, kMark_px, kMark_px);
}

void paint_hue_mark(QPainter& painter, const QPointF& place, const QColor& colour) {
    QPolygonF diamond;
    for (const QPointF& corner : {QPointF(0.0, -kHueMark_px), QPointF(kHueMark_px, 0.0),
                                  QPointF(0.0, kHueMark_px), QPointF(-kHueMark_px, 0.0)})
        diamond << place + corner;
    painter.setBrush(appearance::shown(colour));
    painter.setPen(QPen(kDark, 3.0));
    painter.drawPolygon(diamond);
    painter.setPen(QPen(kLight, 1.5));
    painter.drawPolygon(diamond);
}

QColor mark_colour(const tools::Channels& oklch) {
    const pigment::Srgb8 rgb = tools::colour_from(tools::ColourModel::Oklch, oklch);
    return {rgb[0], rgb[1], rgb[2]};
}

void paint_veil(QPainter& painter, const QPointF& middle, double radius, const QPolygonF& outline,
                QColor colour) {
    QPainterPath inside, beyond;
    inside.addPolygon(outline);
    inside.closeSubpath();
    beyond.addEllipse(middle, radius, radius);
    colour.setAlphaF(0.8F);
    painter.fillPath(beyond.subtracted(inside), colour);
}

void paint_mask_line(QPainter& painter, const QPolygonF& outline, int corners, const QColor& colour) {
    constexpr double kDot_px = 3.0;
    const QColor dark(20, 20, 22);
    painter.setBrush(Qt::NoBrush);
    for (const QPen& pen : {QPen(dark, 2.5), QPen(colour, 1.2)}) {
        painter.setPen(pen);
        painter.drawPolygon(outline);
    }
    painter.setPen(QPen(dark, 1.0));
    painter.setBrush(colour);
    for (int i = 0; i < corners; ++i)
        painter.drawEllipse(outline[i], kDot_px, kDot_px);
}

}  // namespace pastoso::panels
