// The part of CanvasView that feels fingers: one does the work of a mouse, two move, turn and zoom the
// canvas, taps are commands.

#include "view/canvas_view.hpp"

#include <vector>

#include <QKeyEvent>
#include <QPointingDevice>
#include <QTouchEvent>

namespace pastoso::view {
namespace {

std::vector<input::Finger> fingers_down(const QTouchEvent& event) {
    std::vector<input::Finger> down;
    for (const QEventPoint& point : event.points())
        if (point.state() != QEventPoint::Released) down.push_back({point.id(), point.position()});
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
        case QEvent::ShortcutOverride: {
            const bool needed = interactions_.needs_key(*static_cast<QKeyEvent*>(event));
            event->setAccepted(needed);
            return needed || QWidget::event(event);
        }
        case QEvent::KeyPress: {  // before Tab, too, moves the keyboard on
            auto* key = static_cast<QKeyEvent*>(event);
            if (!interactions_.needs_key(*key)) return QWidget::event(event);
            keyPressEvent(key);
            return true;
        }
        case QEvent::PaletteChange:  // another theme has another ground
            screen_->damage_all();
            return QWidget::event(event);
        default:
            return QWidget::event(event);
    }
}

/// False of a touch pad, whose fingers are a mouse.
bool CanvasView::touch(QTouchEvent& event) {
    const QPointingDevice* device = event.pointingDevice();
    if (device == nullptr || device->type() != QInputDevice::DeviceType::TouchScreen) return false;
    event.accept();
    touched_ms_ = event.timestamp();
    touch_modifiers_ = event.modifiers();
    if (event.type() == QEvent::TouchBegin) fingers_heard_ = arbiter_.hears_fingers(touched_ms_);
    if (!fingers_heard_) return true;
    const auto down = fingers_down(event);
    arbiter_.fingers_hold(!down.empty() && event.type() != QEvent::TouchCancel);
    follow(event.type() == QEvent::TouchCancel
               ? gestures_.cancel()
               : gestures_.follow(down, touched_ms_, !pen().fingers_paint));
    if (!gestures_.waits())
        holding_.stop();
    else if (!holding_.isActive())
        holding_.start();
    return true;
}

void CanvasView::follow(const std::vector<input::TouchStep>& steps) {
    using Does = input::TouchStep::Does;
    for (const input::TouchStep& step : steps) {
        switch (step.does) {
            case Does::Press:
                finger_does(input::Kind::Press, step.finger);
                break;
            case Does::Move:
                finger_does(input::Kind::Move, step.finger);
                break;
            case Does::Release:
                finger_does(input::Kind::Release, step.finger);
                break;
            case Does::Cancel:
                finger_does(input::Kind::Cancel, step.finger);
                break;
            case Does::Pinch:
                pinch({device_px(step.from[0]), device_px(step.from[1])},
                      {device_px(step.to[0]), device_px(step.to[1])});
                break;
            case Does::Tap:
                Q_EMIT tapped(step.fingers);
        }
    }
}

/// Where it lifts there is no pointer any more.
void CanvasView::finger_does(input::Kind kind, const input::Finger& finger) {
    deliver(reader_.finger(kind, finger, touched_ms_, touch_modifiers_));
    if (kind != input::Kind::Release && kind != input::Kind::Cancel) return;
    pointer_.reset();
    screen_->refresh();
}

void CanvasView::pinch(const screen::Fingers& from_px, const screen::Fingers& to_px) {
    if (wanted_ == nullptr) return;
    const bool turns = surface_ == document::Surface::Canvas;
    look_from(panned(pinched(view_, from_px, to_px, turns), {0.0, 0.0}, canvas_cells(), window_px()));
    pointer_.reset();
}

void CanvasView::drop_fingers() {
    follow(gestures_.cancel());
    fingers_heard_ = false;
    holding_.stop();
}

void CanvasView::hold_finger() {
    if (!gestures_.waits() || wanted_ == nullptr) return;
    const glm::dvec2 mm = canvas_mm(gestures_.waits_at());
    gestures_.spend();
    Q_EMIT held({mm.x, mm.y});
}

}  // namespace pastoso::view
