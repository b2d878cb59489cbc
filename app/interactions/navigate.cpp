#include "interactions/navigate.hpp"

#include "core/units.hpp"
#include "tools/pen_device_of.hpp"

#include <cmath>

#include <QKeyEvent>
#include <glm/geometric.hpp>

namespace pastoso::interactions {
namespace {

using view::Took;

/// A drag over so many pixels of the desktop doubles the zoom.
constexpr double kDoubling_px = 120.0;

/// So near to the middle a drag has no direction.
constexpr double kNoDirection_px = 6.0;

/// A drag that keeps to steps.
constexpr double kStep_deg = 15.0;

double direction_deg(const glm::dvec2& way) {
    return core::degrees(std::atan2(way.y, way.x));
}

}  // namespace

bool Navigate::is_meant(const input::PointerEvent& event) const {
    if (event.is_pen() && event.button != Qt::LeftButton)
        return tools::action_of(canvas_.pen(), event.button).does == tools::PenButtonDoes::MoveCanvas;
    return event.button == Qt::MiddleButton || (event.button == Qt::LeftButton && space_held_);
}

Took Navigate::press(const input::PointerEvent& event) {
    if (!is_meant(event)) return Took::Nothing;
    begin(event);
    return Took::Pointer;
}

void Navigate::begin(const input::PointerEvent& event) {
    using Kind = Drag::Kind;
    const bool turns = turns_ && event.modifiers.testFlag(Qt::ShiftModifier);
    const bool zooms = event.modifiers.testFlag(Qt::ControlModifier);
    drag_ = Drag{turns   ? Kind::Turn
                 : zooms ? Kind::Zoom
                         : Kind::Pan,
                 event.place, canvas_.view_transform()};
}

void Navigate::drag(const input::PointerEvent& event) {
    if (!drag_) return;
    if (drag_->kind == Drag::Kind::Turn)
        return turn(event.place, event.modifiers.testFlag(Qt::ControlModifier));
    if (drag_->kind == Drag::Kind::Zoom) {
        const double doublings = (drag_->from.y() - event.place.y()) / kDoubling_px;
        return canvas_.look_from(
            zoomed(drag_->start, canvas_.device_px(drag_->from), std::exp2(doublings)));
    }
    canvas_.pan(canvas_.device_px(event.place) - canvas_.device_px(drag_->from));
    drag_->from = event.place;
}

void Navigate::turn(const QPointF& place, bool by_steps) {
    const glm::dvec2 centre = 0.5 * canvas_.window_px();
    const glm::dvec2 from = canvas_.device_px(drag_->from) - centre;
    const glm::dvec2 to = canvas_.device_px(place) - centre;
    const double least_px = kNoDirection_px * canvas_.devicePixelRatioF();
    if (glm::length(from) < least_px || glm::length(to) < least_px) return;
    const screen::ViewTransform& start = drag_->start;
    double angle_deg = start.angle_deg + direction_deg(to) - direction_deg(from);
    if (by_steps) angle_deg = kStep_deg * std::round(angle_deg / kStep_deg);
    canvas_.look_from(turned(start, centre, angle_deg - start.angle_deg));
}

void Navigate::release(const input::PointerEvent& event) {
    if (event.kind == input::Kind::Release) drag(event);
    drag_.reset();
}

bool Navigate::key(const QKeyEvent& event) {
    if (event.key() != Qt::Key_Space) return false;
    if (!event.isAutoRepeat()) space_held_ = event.type() == QEvent::KeyPress;
    return true;
}

std::optional<QCursor> Navigate::cursor() const {
    if (drag_) return Qt::ClosedHandCursor;
    if (space_held_) return Qt::OpenHandCursor;
    return std::nullopt;
}

Took FingerMove::press(const input::PointerEvent& event) {
    if (event.device != input::Device::Finger || canvas_.pen().fingers_paint) return Took::Nothing;
    navigate_.begin(event);
    return Took::Pointer;
}

}  // namespace pastoso::interactions
