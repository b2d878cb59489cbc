#include "panels/canvas/tilt_dial.hpp"

#include <cmath>

#include <QPainter>
#include <QRadialGradient>

namespace pastoso::panels {
namespace {

constexpr double kUpright_deg = 90.0;

void paint_vial(QPainter& painter, const QPointF& centre, double radius) {
    QRadialGradient glass(centre - QPointF(0.3, 0.4) * radius, 1.6 * radius);
    glass.setColorAt(0.0, QColor(126, 142, 84));
    glass.setColorAt(0.7, QColor(84, 98, 54));
    glass.setColorAt(1.0, QColor(58, 68, 38));
    painter.setPen(QPen(QColor(24, 24, 26), 2.0));
    painter.setBrush(glass);
    painter.drawEllipse(centre, radius, radius);
    painter.setBrush(Qt::NoBrush);
    painter.setPen(QPen(QColor(0, 0, 0, 90), 1.0));
    for (const double ring : {1.0 / 3.0, 2.0 / 3.0}) {
        painter.drawEllipse(centre, ring * radius, ring * radius);
    }
}

void paint_bubble(QPainter& painter, const QPointF& place, double size) {
    QRadialGradient air(place - QPointF(0.35, 0.45) * size, 1.4 * size);
    air.setColorAt(0.0, QColor(250, 255, 225, 240));
    air.setColorAt(1.0, QColor(190, 206, 140, 190));
    painter.setPen(QPen(QColor(40, 48, 24), 1.0));
    painter.setBrush(air);
    painter.drawEllipse(place, size, size);
}

void paint_arrow(QPainter& painter, const QPointF& from, const QPointF& to) {
    const QPointF along = to - from;
    const double length = std::hypot(along.x(), along.y());
    if (length < 4.0) return;
    const QPointF unit = along / length;
    const QPointF side(-unit.y(), unit.x());
    painter.setPen(QPen(QColor(240, 240, 240), 2.0, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
    painter.drawLine(from, to);
    painter.drawPolyline(QPolygonF({to - 7.0 * unit + 4.5 * side, to, to - 7.0 * unit - 4.5 * side}));
}

}  // namespace

TiltDial::TiltDial(QWidget* parent) : DirectionDial(kUpright_deg, parent) {
    setToolTip(
        tr("Drag to tilt the canvas: the arrow shows where the paint runs. Double-click lays it flat.\n"
           "Keys: arrows tilt it, Home lays it flat."));
}

void TiltDial::paint_dial(QPainter& painter, const QPointF& centre, double radius,
                          const QPointF& point) {
    paint_vial(painter, centre, radius);
    const double bubble = 0.19 * radius;
    const QPointF high_side = centre - (point - centre) * (1.0 - 0.19 - 0.04);
    paint_bubble(painter, high_side, bubble);
    paint_arrow(painter, centre, point);
}

}  // namespace pastoso::panels
