#include "interactions/pick.hpp"

namespace pastoso::interactions {

using view::Took;

Took Picking::press(const input::PointerEvent& event) {
    const auto pick = event.button == Qt::LeftButton ? wanted(event) : std::nullopt;
    if (!pick) return Took::Nothing;
    Q_EMIT picked({event.pointer.x_mm, event.pointer.y_mm}, *pick);
    return Took::Pointer;
}

void PickNext::arm(std::optional<tools::Pick> pick) {
    next_ = pick;
    canvas_.refresh();
}

std::optional<tools::Pick> PickNext::wanted(const input::PointerEvent& /*event*/) const {
    return next_;
}

std::optional<QCursor> PickNext::cursor() const {
    return next_ ? std::optional(QCursor(Qt::PointingHandCursor)) : std::nullopt;
}

/// On the well Control squeezes paint.
std::optional<tools::Pick> PickByKeys::wanted(const input::PointerEvent& event) const {
    if (event.modifiers.testFlag(Qt::AltModifier)) return tools::Pick::Seen;
    const bool paint =
        event.modifiers.testFlag(Qt::ControlModifier) && surface_ == document::Surface::Canvas;
    return paint ? std::optional(tools::Pick::Paint) : std::nullopt;
}

}  // namespace pastoso::interactions
