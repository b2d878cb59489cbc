// The part of CanvasView that listens to mouse and keys, and what presses of the pen do too.

#include "view/canvas_view.hpp"

#include <QEnterEvent>
#include <QFocusEvent>
#include <QKeyEvent>
#include <QMouseEvent>

namespace pastoso::view {
namespace {

/// So near to a handle a press takes hold of it.
constexpr double kHandleReach_px = 9.0;

}  // namespace

/// Control squeezes paint onto the well instead of painting there.
void CanvasView::touch_down(const tools::Pointer& pointer, Qt::KeyboardModifiers modifiers) {
    if (surface_ == document::Surface::Well && modifiers.testFlag(Qt::ControlModifier))
        return easel_->squeeze(pointer.x_mm, pointer.y_mm);
    easel_->press(pointer, modifiers.testFlag(Qt::ShiftModifier));
    if (surface_ == document::Surface::Canvas) Q_EMIT stroke_begun({pointer.x_mm, pointer.y_mm});
}

void CanvasView::follow_pointer(const QPointF& position) {
    pointer_ = position;
    waiting_.start();
    const glm::dvec2 mm = canvas_mm(position);
    Q_EMIT pointer_moved({mm.x, mm.y});
    update();
}

/// What a press picks, if anything: on the well Control squeezes paint instead.
std::optional<tools::Pick> CanvasView::pick_wanted(Qt::KeyboardModifiers modifiers) const {
    if (picks_next_) return picks_next_;
    if (modifiers.testFlag(Qt::AltModifier)) return tools::Pick::Seen;
    const bool paint = modifiers.testFlag(Qt::ControlModifier) && surface_ == document::Surface::Canvas;
    return paint ? std::optional(tools::Pick::Paint) : std::nullopt;
}

/// Whether the press picks paint, takes hold of a frame or a handle, or draws an area; else it paints.
bool CanvasView::press_guides(const QPointF& position, Qt::KeyboardModifiers modifiers) {
    if (wanted_ == nullptr) return false;
    if (press_light(position)) return true;
    if (frame_ && !picks_next_) {
        press_frame(position);
        return true;
    }
    if (area_form_ && !picks_next_) {
        press_area(position, modifiers);
        return true;
    }
    const glm::dvec2 mm = canvas_mm(position);
    const auto pick = pick_wanted(modifiers);
    picking_ = pick.has_value();
    if (picking_) {
        Q_EMIT picked({mm.x, mm.y}, *pick);
        return true;
    }
    if (surface_ == document::Surface::Well) return false;
    const double reach_mm = kHandleReach_px * devicePixelRatioF() * mm_per_px();
    return handles_shown_ && guide_drag_.press(easel_->hand(), mm, handle_axis_mm(), reach_mm);
}

/// Whether the movement belongs to a press that does not paint.
bool CanvasView::drag_guides(const QPointF& position, Qt::KeyboardModifiers modifiers) {
    if (picking_) return true;
    if (light_drag_) {
        drag_light(position);
        return true;
    }
    if (frame_) {
        if (frame_drag_)
            drag_frame(position, modifiers);
        else
            set_cursor();
        return true;
    }
    if (area_drag_.active()) {
        drag_area(position, modifiers);
        return true;
    }
    if (!guide_drag_.active()) return false;
    const bool square = modifiers.testFlag(Qt::ShiftModifier);
    if (const auto guide = guide_drag_.move(easel_->hand(), canvas_mm(position), square))
        Q_EMIT guide_dragged(*guide);
    update();
    return true;
}

void CanvasView::mousePressEvent(QMouseEvent* event) {
    Q_EMIT pen_used(false);
    follow_pointer(event->position());
    if (event->button() == Qt::MiddleButton || (event->button() == Qt::LeftButton && space_held_)) {
        begin_view_drag(event->position(), event->modifiers());
    } else if (event->button() == Qt::RightButton) {
        if (event->buttons() == Qt::RightButton && !frame_)
            Q_EMIT palette_wanted(event->globalPosition().toPoint());
    } else if (event->button() == Qt::LeftButton &&
               !press_guides(event->position(), event->modifiers())) {
        touch_down(pointer_at(event->position(), event->timestamp()), event->modifiers());
    }
}

void CanvasView::mouseMoveEvent(QMouseEvent* event) {
    if (view_drag_) drag_view(event->position(), event->modifiers());
    follow_pointer(event->position());
    // A release that got lost on its way is made good here.
    if (!event->buttons().testFlag(Qt::LeftButton)) release_pointer();
    if (!view_drag_ && !drag_guides(event->position(), event->modifiers()))
        easel_->move(pointer_at(event->position(), event->timestamp()));
}

void CanvasView::mouseReleaseEvent(QMouseEvent* event) {
    if (view_drag_ && event->button() != Qt::RightButton) {
        end_view_drag();
    } else if (event->button() == Qt::LeftButton) {
        if (easel_->painting()) easel_->move(pointer_at(event->position(), event->timestamp()));
        if (area_drag_.active()) drag_area(event->position(), event->modifiers());
        if (frame_drag_) drag_frame(event->position(), event->modifiers());
        release_pointer();
    }
}

void CanvasView::release_pointer() {
    easel_->release();
    guide_drag_.release();
    frame_drag_.reset();
    light_drag_.reset();
    release_area();
    picking_ = false;
}

void CanvasView::keyPressEvent(QKeyEvent* event) {
    if (press_frame_key(event->key())) return;
    if (event->key() == Qt::Key_Escape) return leave_areas();
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

/// The brush's own outline stands for the cursor, except where the hand moves the canvas or a frame.
void CanvasView::set_cursor() {
    setCursor(view_drag_    ? Qt::ClosedHandCursor
              : space_held_ ? Qt::OpenHandCursor
              : picks_next_ ? Qt::PointingHandCursor
              : frame_      ? frame_cursor()
                            : QCursor(Qt::CrossCursor));
    update();
}

}  // namespace pastoso::view
