#include "panels/canvas/direction_dial.hpp"

#include "appearance/said_value.hpp"
#include "appearance/theme.hpp"
#include "core/units.hpp"
#include "panels/parts/section.hpp"

#include <algorithm>
#include <cmath>

#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>
#include <QWheelEvent>

namespace pastoso::panels {

DirectionDial::DirectionDial(double full_angle_deg, QWidget* parent)
    : QWidget(parent), full_angle_deg_(full_angle_deg) {
    appearance::say_as(*this, QAccessible::Dial);
    setCursor(Qt::CrossCursor);
    setSizePolicy(QSizePolicy::Maximum, QSizePolicy::Maximum);  // in a low window it gives way
    keep_keys_for_canvas(this);
    keep_own_keys(this, {Qt::Key_Left, Qt::Key_Right, Qt::Key_Up, Qt::Key_Down, Qt::Key_Home});
}

void DirectionDial::set(double angle_deg, double azimuth_deg) {
    angle_deg_ = std::clamp(angle_deg, 0.0, full_angle_deg_);
    azimuth_deg_ = azimuth_deg - 360.0 * std::floor(azimuth_deg / 360.0);
    appearance::say_value(*this, value_words());
    update();
}

void DirectionDial::drag_to(double angle_deg, double azimuth_deg) {
    set(angle_deg, azimuth_deg);
    Q_EMIT dragged(angle_deg_, azimuth_deg_);
}

QPointF DirectionDial::centre() const {
    return QRectF(rect()).center();
}

double DirectionDial::radius() const {
    return 0.5 * std::min(width(), height()) - 7.0;
}

void DirectionDial::drag_to_point(const QPointF& position) {
    const QPointF offset = position - centre();
    const double distance = std::hypot(offset.x(), offset.y()) / radius();
    // The last few pixels of the disc stand for its centre, so that flat and level are easy to hit.
    const double angle_deg = distance < 0.06 ? 0.0 : std::round(distance * full_angle_deg_);
    drag_to(angle_deg, std::round(core::degrees(std::atan2(offset.y(), offset.x()))));
}

void DirectionDial::mousePressEvent(QMouseEvent* event) {
    drag_to_point(event->position());
}

void DirectionDial::mouseMoveEvent(QMouseEvent* event) {
    if (event->buttons() != Qt::NoButton) drag_to_point(event->position());
}

void DirectionDial::mouseDoubleClickEvent(QMouseEvent*) {
    reset();
}

void DirectionDial::wheelEvent(QWheelEvent* event) {
    drag_to(angle_deg_ + (event->angleDelta().y() > 0 ? 1.0 : -1.0), azimuth_deg_);
}

/// The point moves as the arrow points, Home does what a double click does.
void DirectionDial::keyPressEvent(QKeyEvent* event) {
    constexpr double kStep_deg = 2.0;
    switch (event->key()) {
        case Qt::Key_Left:
            return step({-kStep_deg, 0.0});
        case Qt::Key_Right:
            return step({kStep_deg, 0.0});
        case Qt::Key_Up:
            return step({0.0, -kStep_deg});
        case Qt::Key_Down:
            return step({0.0, kStep_deg});
        case Qt::Key_Home:
            return reset();
        default:
            QWidget::keyPressEvent(event);
    }
}

void DirectionDial::step(const QPointF& way_deg) {
    const double azimuth = core::radians(azimuth_deg_);
    const QPointF to = angle_deg_ * QPointF(std::cos(azimuth), std::sin(azimuth)) + way_deg;
    const double angle_deg = std::hypot(to.x(), to.y());
    // At the centre every direction is the same; the last one stays.
    drag_to(angle_deg, angle_deg < 1e-9 ? azimuth_deg_ : core::degrees(std::atan2(to.y(), to.x())));
}

void DirectionDial::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    const double distance = radius() * angle_deg_ / full_angle_deg_;
    const double azimuth = core::radians(azimuth_deg_);
    const QPointF point = centre() + distance * QPointF(std::cos(azimuth), std::sin(azimuth));
    paint_dial(painter, centre(), radius(), point);
    if (!hasFocus()) return;
    painter.setPen(QPen(appearance::colours().focus, 2.0));
    painter.setBrush(Qt::NoBrush);
    painter.drawEllipse(centre(), radius() + 3.5, radius() + 3.5);
}

}  // namespace pastoso::panels
