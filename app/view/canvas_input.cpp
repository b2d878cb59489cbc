// The part of CanvasView that listens to pen, mouse and keys.

#include "view/canvas_view.hpp"

#include <cmath>

#include <QEnterEvent>
#include <QFocusEvent>
#include <QKeyEvent>
#include <QMouseEvent>
#include <QPointingDevice>
#include <QTabletEvent>
#include <QWheelEvent>

namespace pastoso::view {
namespace {

/// One notch of a wheel (120 eighths of a degree) zooms by this factor.
constexpr double kZoomPerNotch = 1.25;
constexpr double kNotch = 120.0;

}  // namespace

tools::Pointer CanvasView::mouse_pointer(const QMouseEvent& event) const {
    const glm::dvec2 mm = canvas_mm(event.position());
    tools::Pointer pointer;
    pointer.surface = surface_;
    pointer.x_mm = mm.x;
    pointer.y_mm = mm.y;
    pointer.pressure = tools::kMousePressure;
    pointer.time_ms = event.timestamp();
    return pointer;
}

tools::Pointer CanvasView::pen_pointer(const QTabletEvent& event) const {
    const glm::dvec2 mm = canvas_mm(event.position());
    tools::Pointer pointer;
    pointer.surface = surface_;
    pointer.x_mm = mm.x;
    pointer.y_mm = mm.y;
    pointer.pressure = event.pressure();
    pointer.tilt_x_deg = event.xTilt();
    pointer.tilt_y_deg = event.yTilt();
    pointer.time_ms = event.timestamp();
    const QPointingDevice* device = event.pointingDevice();
    if (device != nullptr && device->capabilities().testFlag(QInputDevice::Capability::Rotation)) {
        pointer.rotation_deg = event.rotation();
    }
    return pointer;
}

/// Control squeezes paint onto the well instead of painting there.
void CanvasView::touch_down(const tools::Pointer& pointer, Qt::KeyboardModifiers modifiers) {
    if (surface_ == document::Surface::Well && modifiers.testFlag(Qt::ControlModifier))
        easel_->squeeze(pointer.x_mm, pointer.y_mm);
    else
        easel_->press(pointer, modifiers.testFlag(Qt::ShiftModifier));
}

void CanvasView::follow_pointer(const QPointF& position) {
    pointer_ = position;
    waiting_.start();
    const glm::dvec2 mm = canvas_mm(position);
    Q_EMIT pointer_moved({mm.x, mm.y});
    update();
}

void CanvasView::mousePressEvent(QMouseEvent* event) {
    follow_pointer(event->position());
    if (event->button() == Qt::MiddleButton || (event->button() == Qt::LeftButton && space_held_)) {
        start_panning(event->position());
    } else if (event->button() == Qt::LeftButton) {
        touch_down(mouse_pointer(*event), event->modifiers());
    }
}

void CanvasView::mouseMoveEvent(QMouseEvent* event) {
    if (pan_from_) pan_to(event->position());
    follow_pointer(event->position());
    // A release that got lost on its way is made good here.
    if (!event->buttons().testFlag(Qt::LeftButton)) easel_->release();
    if (!pan_from_) easel_->move(mouse_pointer(*event));
}

void CanvasView::mouseReleaseEvent(QMouseEvent* event) {
    if (pan_from_ && event->button() != Qt::RightButton) {
        pan_from_.reset();
        set_cursor();
    } else if (event->button() == Qt::LeftButton) {
        easel_->move(mouse_pointer(*event));
        easel_->release();
    }
}

void CanvasView::tabletEvent(QTabletEvent* event) {
    event->accept();
    if (pan_from_) pan_to(event->position());
    follow_pointer(event->position());
    switch (event->type()) {
        case QEvent::TabletPress:
            if (space_held_ || event->button() == Qt::MiddleButton) {
                start_panning(event->position());
            } else if (event->button() == Qt::LeftButton) {
                touch_down(pen_pointer(*event), event->modifiers());
            }
            break;
        case QEvent::TabletRelease:
            pan_from_.reset();
            if (event->button() == Qt::LeftButton) easel_->release();
            set_cursor();
            break;
        default:
            if (!event->buttons().testFlag(Qt::LeftButton)) easel_->release();
            if (!pan_from_) easel_->move(pen_pointer(*event));
    }
}

void CanvasView::wheelEvent(QWheelEvent* event) {
    const double notches = event->angleDelta().y() / kNotch;
    if (notches == 0.0) return;
    fitted_ = false;
    set_view(zoomed(view_, device_px(event->position()), std::pow(kZoomPerNotch, notches)));
    follow_pointer(event->position());
}

void CanvasView::start_panning(const QPointF& position) {
    easel_->release();
    pan_from_ = position;
    set_cursor();
}

void CanvasView::pan_to(const QPointF& position) {
    const glm::dvec2 drag = device_px(position) - device_px(*pan_from_);
    pan_from_ = position;
    fitted_ = false;
    if (wanted_ != nullptr) set_view(panned(view_, drag, canvas_cells(), window_px()));
}

void CanvasView::keyPressEvent(QKeyEvent* event) {
    if (event->key() != Qt::Key_Space) return QOpenGLWidget::keyPressEvent(event);
    if (event->isAutoRepeat()) return;
    space_held_ = true;
    set_cursor();
}

void CanvasView::keyReleaseEvent(QKeyEvent* event) {
    if (event->key() != Qt::Key_Space) return QOpenGLWidget::keyReleaseEvent(event);
    if (event->isAutoRepeat()) return;
    space_held_ = false;
    set_cursor();
}

void CanvasView::focusOutEvent(QFocusEvent* event) {
    space_held_ = false;
    set_cursor();
    QOpenGLWidget::focusOutEvent(event);
}

void CanvasView::enterEvent(QEnterEvent* event) {
    if (window()->isActiveWindow()) setFocus(Qt::MouseFocusReason);
    follow_pointer(event->position());
}

void CanvasView::leaveEvent(QEvent*) {
    pointer_.reset();
    Q_EMIT pointer_left();
    update();
}

/// The brush's own outline stands for the cursor, except where the hand moves the canvas.
void CanvasView::set_cursor() {
    setCursor(pan_from_ ? Qt::ClosedHandCursor : space_held_ ? Qt::OpenHandCursor : Qt::CrossCursor);
    update();
}

}  // namespace pastoso::view
