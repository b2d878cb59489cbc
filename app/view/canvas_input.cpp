// The part of CanvasView that listens to mouse, pens and keys.

#include "view/canvas_view.hpp"
#include "view/turned_pen.hpp"

#include <utility>

#include <QApplication>
#include <QCursor>
#include <QEnterEvent>
#include <QFocusEvent>
#include <QKeyEvent>
#include <QMouseEvent>
#include <QTabletEvent>

namespace pastoso::view {

/// With its place on the canvas, and tilt and rotation told against the canvas.
input::PointerEvent CanvasView::over_canvas(input::PointerEvent event) const {
    const glm::dvec2 mm = canvas_mm(event.place);
    event.pointer.surface = surface_;
    event.pointer.x_mm = mm.x;
    event.pointer.y_mm = mm.y;
    event.pointer = against_canvas(view_, event.pointer);
    return event;
}

/// Of a mouse or a pen.
void CanvasView::hear(const input::PointerEvent& event) {
    const auto verdict = arbiter_.judge(event);
    if (verdict == input::Arbiter::Verdict::Ignore) return;
    if (verdict == input::Arbiter::Verdict::TakeOver) drop_fingers();
    Q_EMIT pointer_heard(static_cast<double>(event.pointer.time_ms));
    if (event.is_pen() || event.kind == input::Kind::Press)
        Q_EMIT pen_used(event.device == input::Device::Eraser);
    const int notches = event.wheel ? wheel_.moved_to(*event.wheel) : 0;
    if (notches != 0) Q_EMIT wheel_turned(notches);
    deliver(event);
}

void CanvasView::deliver(const input::PointerEvent& event) {
    pen_ = event.is_pen() ? std::optional(event) : std::nullopt;
    move_pointer(event.place);
    if (wanted_ != nullptr) interactions_.handle(over_canvas(event));
    refresh();
}

void CanvasView::move_pointer(const QPointF& place) {
    pointer_ = place;
    const glm::dvec2 mm = canvas_mm(place);
    Q_EMIT pointer_moved({mm.x, mm.y});
}

/// The brush's own outline stands for the cursor where nothing else has one.
void CanvasView::refresh() {
    const QCursor wanted = interactions_.cursor();
    if (!(cursor() == wanted)) setCursor(wanted);
    screen_->refresh();
}

void CanvasView::mousePressEvent(QMouseEvent* event) {
    hear(reader_.read(*event));
}

void CanvasView::mouseMoveEvent(QMouseEvent* event) {
    hear(reader_.read(*event));
}

void CanvasView::mouseReleaseEvent(QMouseEvent* event) {
    hear(reader_.read(*event));
}

void CanvasView::tabletEvent(QTabletEvent* event) {
    event->accept();
    if (!closes_popup(*event)) hear(reader_.read(*event));
}

/// What is open over the window goes away at a press beside it, as it does at a click: pens are told to
/// what lies below.
bool CanvasView::closes_popup(const QTabletEvent& event) {
    QWidget* popup = QApplication::activePopupWidget();
    if (event.type() == QEvent::TabletPress && popup != nullptr) {
        closing_popup_ = true;
        popup->close();
    }
    if (closing_popup_ && event.buttons() == Qt::NoButton) return std::exchange(closing_popup_, false);
    return closing_popup_;
}

/// What it still pressed has lifted: of a pen that lifts and leaves at once, Qt tells under Wayland only
/// that it leaves.
void CanvasView::lose_pen() {
    if (!pen_) return;
    input::PointerEvent last = *pen_;
    last.kind = input::Kind::Move;
    last.button = Qt::NoButton;
    last.pointer.pressure = 0.0;
    if (std::exchange(last.buttons, Qt::NoButton) != Qt::NoButton) hear(last);
    pen_.reset();
    forget_pointer();
}

void CanvasView::keyPressEvent(QKeyEvent* event) {
    const bool taken = interactions_.key(*event);
    if (!taken && event->key() != Qt::Key_Escape) return QWidget::keyPressEvent(event);
    if (!taken) Q_EMIT escaped();
    refresh();
}

void CanvasView::keyReleaseEvent(QKeyEvent* event) {
    if (!interactions_.key(*event)) return QWidget::keyReleaseEvent(event);
    refresh();
}

void CanvasView::focusOutEvent(QFocusEvent* event) {
    interactions_.keys_lost();
    refresh();
    QWidget::focusOutEvent(event);
}

/// A pointer that did not move has not come: what lay over the canvas was closed.
void CanvasView::enterEvent(QEnterEvent* event) {
    const bool comes = left_at_ != event->globalPosition().toPoint();
    if (comes && window()->isActiveWindow()) setFocus(Qt::MouseFocusReason);
    move_pointer(event->position());
    refresh();
}

void CanvasView::leaveEvent(QEvent*) {
    left_at_ = QCursor::pos();
    forget_pointer();
}

void CanvasView::forget_pointer() {
    pointer_.reset();
    Q_EMIT pointer_left();
    screen_->refresh();
}

}  // namespace pastoso::view
