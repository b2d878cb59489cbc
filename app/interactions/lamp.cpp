#include "interactions/lamp.hpp"

#include <algorithm>

#include <QPainter>
#include <QRadialGradient>
#include <glm/geometric.hpp>

namespace pastoso::interactions {
namespace {

using view::Took;

constexpr double kDial_px = 120.0, kHandle_px = 11.0, kReach_px = 16.0;

QPointF point(const glm::dvec2& px) {
    return {px.x, px.y};
}

glm::dvec2 place_of(const input::PointerEvent& event) {
    return {event.place.x(), event.place.y()};
}

}  // namespace

void Lamp::show(bool shown) {
    shown_ = shown;
    cancel();
    canvas_.refresh();
}

LightDial Lamp::dial() const {
    const glm::dvec2 window{canvas_.width(), canvas_.height()};
    return {0.5 * window, std::min(kDial_px, 0.4 * std::min(window.x, window.y))};
}

LightDirection Lamp::direction() const {
    return {canvas_.lighting().azimuth_deg, canvas_.lighting().elevation_deg};
}

Took Lamp::press(const input::PointerEvent& event) {
    if (!shown_ || event.button != Qt::LeftButton) return Took::Nothing;
    const glm::dvec2 handle = light_handle_px(dial(), canvas_.view_transform(), direction());
    if (glm::distance(place_of(event), handle) > kReach_px) return Took::Nothing;
    to_lamp_ = handle - place_of(event);
    return Took::Pointer;
}

void Lamp::drag(const input::PointerEvent& event) {
    if (!to_lamp_) return;
    const LightDirection light =
        light_at(dial(), canvas_.view_transform(), place_of(event) + *to_lamp_, direction());
    Q_EMIT dragged(light.elevation_deg, light.azimuth_deg);
}

void Lamp::draw(const view::Overlay& overlay) {
    if (!shown_) return;
    overlay.painter.draw([this](QPainter& painter) { paint(painter); });
}

void Lamp::paint(QPainter& painter) const {
    const LightDial round = dial();
    const QPointF centre = point(round.centre_px);
    const QPointF lamp = point(light_handle_px(round, canvas_.view_transform(), direction()));
    painter.setRenderHint(QPainter::Antialiasing);
    const auto twice = [&](const auto& draw) {
        painter.setPen(QPen(QColor(0, 0, 0, 110), 3.0));
        draw();
        painter.setPen(QPen(QColor(255, 255, 255, 170), 1.2));
        draw();
    };
    painter.setBrush(Qt::NoBrush);
    twice([&] { painter.drawEllipse(centre, round.radius_px, round.radius_px); });
    twice([&] { painter.drawLine(lamp, centre); });
    QRadialGradient glow(lamp, 2.4 * kHandle_px);
    glow.setColorAt(0.0, QColor(255, 226, 130, 210));
    glow.setColorAt(1.0, QColor(255, 226, 130, 0));
    painter.setPen(Qt::NoPen);
    painter.setBrush(glow);
    painter.drawEllipse(lamp, 2.4 * kHandle_px, 2.4 * kHandle_px);
    painter.setPen(QPen(QColor(60, 45, 10), 1.5));
    painter.setBrush(QColor(255, 214, 90));
    painter.drawEllipse(lamp, kHandle_px, kHandle_px);
}

}  // namespace pastoso::interactions
