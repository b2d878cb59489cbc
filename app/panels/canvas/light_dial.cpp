#include "panels/canvas/light_dial.hpp"

#include "shade/render.hpp"

#include <QPainter>
#include <QRadialGradient>

namespace pastoso::panels {
namespace {

constexpr double kLowestElevation_deg = 8.0;

}  // namespace

LightDial::LightDial(QWidget* parent) : DirectionDial(90.0 - kLowestElevation_deg, parent) {
    const shade::Lighting usual;
    set_light(usual.elevation_deg, usual.azimuth_deg);
    setToolTip(
        tr("Drag the lamp: near the rim it rakes over the relief. Double-click puts it back.\n"
           "Keys: arrows move it, Home puts it back."));
}

QString LightDial::value_words() const {
    return tr("%1\u00b0 high, from %2\u00b0")
        .arg(elevation_deg(), 0, 'f', 0)
        .arg(light_azimuth_deg(), 0, 'f', 0);
}

void LightDial::reset() {
    const shade::Lighting usual;
    drag_to(90.0 - usual.elevation_deg, 360.0 - usual.azimuth_deg);
}

void LightDial::paint_dial(QPainter& painter, const QPointF& centre, double radius,
                           const QPointF& point) {
    QRadialGradient glow(point, 1.7 * radius);
    glow.setColorAt(0.0, QColor(235, 228, 210));
    glow.setColorAt(0.35, QColor(150, 147, 140));
    glow.setColorAt(1.0, QColor(40, 40, 43));
    painter.setPen(QPen(QColor(24, 24, 26), 2.0));
    painter.setBrush(glow);
    painter.drawEllipse(centre, radius, radius);
    painter.setPen(QPen(QColor(60, 50, 20), 1.2));
    painter.setBrush(QColor(255, 214, 90));
    painter.drawEllipse(point, 5.5, 5.5);
}

}  // namespace pastoso::panels
