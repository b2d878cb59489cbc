// What mouse, wheel and keys do on the board of references.
#include "appearance/cursors.hpp"
#include "panels/references/reference_places.hpp"
#include "panels/references/reference_view.hpp"

#include <cmath>
#include <utility>

#include <QApplication>
#include <QDropEvent>
#include <QEnterEvent>
#include <QKeyEvent>
#include <QMimeData>
#include <QMouseEvent>

namespace pastoso::panels {
namespace {

constexpr double kZoomStep = 1.25;
constexpr double kScaleStep = 1.1;
constexpr double kTurnStep_deg = 5.0;
constexpr double kKeyStep = 8.0;  ///< in units of the widget
constexpr double kReach = 9.0;    ///< within which a handle is taken

double distance(const QPointF& a, const QPointF& b) {
    return std::sqrt(QPointF::dotProduct(a - b, a - b));
}

}  // namespace

void ReferenceView::resizeEvent(QResizeEvent*) {
    if (fitted_) fit();
}

bool ReferenceView::would_pick(Qt::KeyboardModifiers keys) const {
    return pick_next_ || (keys & (Qt::ControlModifier | Qt::AltModifier)) != 0;
}

bool ReferenceView::picks(const QMouseEvent& event) const {
    return event.button() == Qt::LeftButton && would_pick(event.modifiers());
}

void ReferenceView::pick(const QPointF& position) {
    if (const auto colour = colour_at(position)) Q_EMIT colour_picked(*colour);
}

/// A handle of the chosen picture, the picture below the pointer, or the board.
ReferenceView::Gesture ReferenceView::gesture_at(const QPointF& position) const {
    Gesture gesture{.drag = Drag::View, .from = position, .last = position};
    const auto begin = [&](Drag drag, const document::Reference& one) {
        gesture.drag = drag;
        gesture.before = one;
    };
    if (const document::Reference* one = chosen()) {
        if (distance(position, turn_handle(*one)) <= kReach) begin(Drag::Turn, *one);
        const auto corners = corners_mm(*one);
        for (std::size_t corner = 0; corner < corners.size(); ++corner) {
            if (distance(position, widget_position(corners[corner])) > kReach) continue;
            begin(Drag::Corner, *one);
            gesture.corner = corner;
        }
    }
    if (gesture.drag != Drag::View) return gesture;
    const document::Reference* below = reference_at(shown_, board_mm(position));
    if (below != nullptr) begin(Drag::Move, *below);
    return gesture;
}

QCursor ReferenceView::cursor_of(const Gesture& gesture) const {
    if (gesture.drag == Drag::Turn) return appearance::turning_cursor();
    if (gesture.drag == Drag::Move) return Qt::SizeAllCursor;
    if (gesture.drag != Drag::Corner) return Qt::ArrowCursor;
    const document::Reference* one = chosen();
    const document::Reference& held = one == nullptr ? gesture.before : *one;
    return appearance::scaling_cursor(widget_position(corners_mm(held)[gesture.corner]) -
                                      widget_position({held.place.x_mm, held.place.y_mm}));
}

void ReferenceView::show_cursor(const QPointF& position, bool picks) {
    const bool drags = gesture_.drag != Drag::None;
    if (drags && gesture_.drag == Drag::View)
        setCursor(Qt::ClosedHandCursor);
    else if (!drags && picks)
        setCursor(Qt::CrossCursor);
    else if (!drags && space_held_)
        setCursor(Qt::OpenHandCursor);
    else
        setCursor(cursor_of(drags ? gesture_ : gesture_at(position)));
}

void ReferenceView::mousePressEvent(QMouseEvent* event) {
    if (gesture_.drag != Drag::None) return;
    if (picks(*event)) return pick(event->position());
    finish();
    const bool moves_view = event->button() == Qt::MiddleButton || space_held_;
    if (moves_view)
        gesture_ = {.drag = Drag::View, .from = event->position(), .last = event->position()};
    else if (event->button() == Qt::LeftButton)
        begin_gesture(event->position());
    show_cursor(event->position(), false);
}

/// What is moved is chosen; beside the pictures none is.
void ReferenceView::begin_gesture(const QPointF& position) {
    gesture_ = gesture_at(position);
    if (gesture_.drag == Drag::Move) choose(gesture_.before.id);
    if (gesture_.drag == Drag::View) choose(0);
}

void ReferenceView::drag_chosen(const QPointF& position, bool in_steps) {
    const document::Reference& before = gesture_.before;
    document::ReferencePlace place = before.place;
    if (gesture_.drag == Drag::Corner) {
        place = with_corner_at(before, gesture_.corner, board_mm(position));
    } else if (gesture_.drag == Drag::Turn) {
        place = facing(place, board_mm(position), in_steps);
    } else {
        const QPointF way_mm = board_mm(position) - board_mm(gesture_.from);
        place.x_mm += way_mm.x();
        place.y_mm += way_mm.y();
    }
    place_chosen(place);
}

void ReferenceView::mouseMoveEvent(QMouseEvent* event) {
    show_cursor(event->position(), would_pick(event->modifiers()));
    if (gesture_.drag == Drag::None) return;
    const QPointF step = event->position() - std::exchange(gesture_.last, event->position());
    if (gesture_.drag == Drag::View) return move_view(step);
    const QPointF way = event->position() - gesture_.from;
    const bool has_begun = !is_said_ || way.manhattanLength() >= QApplication::startDragDistance();
    if (has_begun) drag_chosen(event->position(), event->modifiers().testFlag(Qt::ShiftModifier));
}

void ReferenceView::mouseReleaseEvent(QMouseEvent* event) {
    if ((event->buttons() & (Qt::LeftButton | Qt::MiddleButton)) != 0) return;
    gesture_ = {};
    finish();
    show_cursor(event->position(), would_pick(event->modifiers()));
}

void ReferenceView::mouseDoubleClickEvent(QMouseEvent* event) {
    if (picks(*event) || event->button() != Qt::LeftButton) return mousePressEvent(event);
    const document::Reference* below = reference_at(shown_, board_mm(event->position()));
    if (below != nullptr)
        fit(extent_mm(*below));
    else
        fit();
}

void ReferenceView::wheelEvent(QWheelEvent* event) {
    constexpr double kNotch = 120.0;
    const double notches = (event->angleDelta().x() + event->angleDelta().y()) / kNotch;
    if (event->modifiers().testFlag(Qt::ShiftModifier))
        turn_chosen(kTurnStep_deg * notches);
    else
        zoom_about(event->position(), std::pow(kZoomStep, notches));
    event->accept();
}

/// The chosen picture, or the view where none is.
void ReferenceView::move_by_key(const QPointF& direction, bool turns) {
    const document::Reference* one = chosen();
    if (turns) return turn_chosen(kTurnStep_deg * direction.x());
    if (one == nullptr) return move_view(-3.0 * kKeyStep * direction);
    document::ReferencePlace place = one->place;
    place.x_mm += kKeyStep / zoom_ * direction.x();
    place.y_mm += kKeyStep / zoom_ * direction.y();
    place_chosen(place);
}

void ReferenceView::zoom_by_key(double factor) {
    if (chosen() == nullptr) return zoom_about(0.5 * QPointF(width(), height()), factor);
    scale_chosen(factor > 1.0 ? kScaleStep : 1.0 / kScaleStep);
}

void ReferenceView::keyPressEvent(QKeyEvent* event) {
    if (event->matches(QKeySequence::Paste)) return Q_EMIT paste_wanted();
    const bool shift = event->modifiers().testFlag(Qt::ShiftModifier);
    switch (event->key()) {
        case Qt::Key_Left:
            return move_by_key({-1.0, 0.0}, shift);
        case Qt::Key_Right:
            return move_by_key({1.0, 0.0}, shift);
        case Qt::Key_Up:
            return move_by_key({0.0, -1.0}, false);
        case Qt::Key_Down:
            return move_by_key({0.0, 1.0}, false);
        case Qt::Key_Plus:
            return zoom_by_key(kZoomStep);
        case Qt::Key_Minus:
            return zoom_by_key(1.0 / kZoomStep);
        case Qt::Key_0:
            return fit();
        case Qt::Key_Delete:
            return remove_chosen();
        case Qt::Key_PageUp:
            return raise_chosen(1);
        case Qt::Key_PageDown:
            return raise_chosen(-1);
        case Qt::Key_Return:
            return choose_next();
        case Qt::Key_Space:
            space_held_ = true;
            return;
        default:
            QWidget::keyPressEvent(event);
    }
}

void ReferenceView::keyReleaseEvent(QKeyEvent* event) {
    if (event->key() == Qt::Key_Space && !event->isAutoRepeat()) space_held_ = false;
    QWidget::keyReleaseEvent(event);
}

void ReferenceView::enterEvent(QEnterEvent* event) {
    show_cursor(event->position(), would_pick(event->modifiers()));
    QWidget::enterEvent(event);
}

void ReferenceView::focusOutEvent(QFocusEvent* event) {
    space_held_ = false;
    QWidget::focusOutEvent(event);
}

void ReferenceView::dragEnterEvent(QDragEnterEvent* event) {
    if (!event->mimeData()->hasUrls() && !event->mimeData()->hasImage()) return;
    event->setDropAction(Qt::CopyAction);
    event->accept();
}

void ReferenceView::dropEvent(QDropEvent* event) {
    event->setDropAction(Qt::CopyAction);
    event->accept();
    Q_EMIT dropped(*event->mimeData(), board_mm(event->position()));
}

}  // namespace pastoso::panels
