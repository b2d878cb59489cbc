// The part of CanvasView that feels fingers: one paints, two move, turn and zoom the canvas.

#include "view/canvas_view.hpp"

#include <cmath>
#include <vector>

#include <QPointingDevice>
#include <QTouchEvent>

namespace pastoso::view {
namespace {

/// A finger that has moved by less may still be the first of two.
constexpr double kStill_px = 8.0;

std::vector<QEventPoint> fingers_down(const QTouchEvent& event) {
    std::vector<QEventPoint> down;
    for (const QEventPoint& point : event.points())
        if (point.state() != QEventPoint::Released) down.push_back(point);
    return down;
}

}  // namespace

bool CanvasView::event(QEvent* event) {
    switch (event->type()) {
        case QEvent::TouchBegin:
        case QEvent::TouchUpdate:
        case QEvent::TouchEnd:
        case QEvent::TouchCancel:
            return touch(*static_cast<QTouchEvent*>(event));
        case QEvent::PaletteChange:  // another theme has another ground
            damage_all();
            return QOpenGLWidget::event(event);
        default:
            return QOpenGLWidget::event(event);
    }
}

/// False of a touch pad, whose fingers are a mouse.
bool CanvasView::touch(QTouchEvent& event) {
    const QPointingDevice* device = event.pointingDevice();
    if (device == nullptr || device->type() != QInputDevice::DeviceType::TouchScreen) return false;
    event.accept();
    if (event.type() == QEvent::TouchBegin) touch_ = Touch{};
    const std::vector<QEventPoint> down = fingers_down(event);
    if (event.type() == QEvent::TouchCancel)
        lift_finger(event, false);
    else if (down.size() >= 2 && touch_.does != Touch::Does::Paint)
        pinch(down[0], down[1]);
    else if (down.size() == 1 && touch_.does != Touch::Does::Pinch)
        move_finger(event, down[0]);
    else if (down.empty())
        lift_finger(event, true);
    return true;
}

void CanvasView::pinch(const QEventPoint& first, const QEventPoint& second) {
    const Fingers now{device_px(first.position()), device_px(second.position())};
    const bool same =
        touch_.does == Touch::Does::Pinch && touch_.ids == std::array{first.id(), second.id()};
    if (same && wanted_ != nullptr) {
        const bool turns = surface_ == document::Surface::Canvas;
        const ViewTransform next = pinched(view_, touch_.fingers_px, now, turns);
        fitted_ = false;
        set_view(panned(next, {0.0, 0.0}, canvas_cells(), window_px()));
    }
    touch_ = {Touch::Does::Pinch, {}, {first.id(), second.id()}, now};
    pointer_.reset();
}

void CanvasView::move_finger(const QTouchEvent& event, const QEventPoint& finger) {
    const QPointF position = finger.position();
    if (touch_.does == Touch::Does::Nothing) {
        touch_.does = Touch::Does::Wait;
        touch_.from = position;
    }
    if (touch_.does == Touch::Does::Wait) {
        const QPointF way = position - touch_.from;
        if (std::hypot(way.x(), way.y()) < kStill_px) return;
        put_finger_down(event);
    }
    follow_pointer(position);
    if (!drag_guides(position, event.modifiers())) easel_->move(pointer_at(position, event.timestamp()));
}

/// Where the finger touched first.
void CanvasView::put_finger_down(const QTouchEvent& event) {
    touch_.does = Touch::Does::Paint;
    mouse_pressure_ = {};  // it comes from nowhere
    follow_pointer(touch_.from);
    if (!press_guides(touch_.from, event.modifiers()))
        touch_down(pointer_at(touch_.from, event.timestamp()), event.modifiers());
}

/// A finger that hardly moved leaves a touch of paint, unless it was not meant.
void CanvasView::lift_finger(const QTouchEvent& event, bool meant) {
    if (touch_.does == Touch::Does::Wait && meant) put_finger_down(event);
    if (touch_.does == Touch::Does::Paint) release_pointer();
    touch_ = Touch{};
    pointer_.reset();
    update();
}

}  // namespace pastoso::view
