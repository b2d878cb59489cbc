#include "panels/canvas/tilt_dial.hpp"

#include <QPainter>
#include <QRadialGradient>

namespace pastoso::panels {
namespace {

constexpr double kUpright_deg = 90.0;
constexpr double kKnobRadius_px = 6.0;

/// The canvas seen along its normal, with rings at a third and two thirds of the way to upright.
void paint_canvas(QPainter& painter, const QPointF& centre, double radius) {
    QRadialGradient cloth(centre - QPointF(0.3, 0.4) * radius, 1.6 * radius);
    cloth.setColorAt(0.0, QColor(112, 108, 100));
    cloth.setColorAt(0.7, QColor(84, 81, 75));
    cloth.setColorAt(1.0, QColor(58, 56, 52));
    painter.setPen(QPen(QColor(24, 24, 26), 2.0));
    painter.setBrush(cloth);
    painter.drawEllipse(centre, radius, radius);
    painter.setBrush(Qt::NoBrush);
    painter.setPen(QPen(QColor(0, 0, 0, 90), 1.0));
    for (const double ring : {1.0 / 3.0, 2.0 / 3.0}) {
        painter.drawEllipse(centre, ring * radius, ring * radius);
    }
}

/// The way that paint runs, from where the canvas lies flat to the knob.
void paint_run(QPainter& painter, const QPointF& from, const QPointF& to) {
    painter.setPen(QPen(QColor(240, 240, 240), 2.5, Qt::SolidLine, Qt::RoundCap));
    painter.drawLine(from, to);
}

void paint_knob(QPainter& painter, const QPointF& place) {
    painter.setPen(QPen(QColor(24, 24, 26), 1.2));
    painter.setBrush(QColor(240, 240, 240));
    painter.drawEllipse(place, kKnobRadius_px, kKnobRadius_px);
}

}  // namespace

TiltDial::TiltDial(QWidget* parent) : DirectionDial(kUpright_deg, parent) {
    setToolTip(
        tr("Drag to tilt the canvas: the paint runs towards the knob. Double-click lays it flat.\n"
           "Keys: arrows tilt it, Home lays it flat."));
    set(angle_deg(), azimuth_deg());
}

QString TiltDial::value_words() const {
    if (angle_deg() == 0.0) return tr("flat");
    return tr("%1\u00b0 steep, down is at %2\u00b0")
        .arg(angle_deg(), 0, 'f', 0)
        .arg(azimuth_deg(), 0, 'f', 0);
}

void TiltDial::paint_dial(QPainter& painter, const QPointF& centre, double radius,
                          const QPointF& point) {
    paint_canvas(painter, centre, radius);
    paint_run(painter, centre, point);
    paint_knob(painter, point);
}

}  // namespace pastoso::panels
