#include "interactions/areas.hpp"

#include "interactions/event_place.hpp"

#include <QKeyEvent>

namespace pastoso::interactions {
namespace {

using view::Took;

/// Shift adds, Alt takes away, both keep what is common.
grid::Combination combination(Qt::KeyboardModifiers modifiers) {
    const bool shift = modifiers.testFlag(Qt::ShiftModifier);
    if (modifiers.testFlag(Qt::AltModifier))
        return shift ? grid::Combination::Intersect : grid::Combination::Subtract;
    return shift ? grid::Combination::Add : grid::Combination::Replace;
}

}  // namespace

void Areas::draw_next(std::optional<AreaForm> form) {
    form_ = form;
    drag_.cancel();
    canvas_.refresh();
}

Took Areas::press(const input::PointerEvent& event) {
    if (!form_ || event.button != Qt::LeftButton) return Took::Nothing;
    drag_.press(*form_, place_mm(event), combination(event.modifiers));
    Q_EMIT begun(drag_.how());
    return Took::Pointer;
}

void Areas::drag(const input::PointerEvent& event) {
    if (!drag_.active()) return;
    drag_.move(place_mm(event), canvas_.px_mm(), event.modifiers.testFlag(Qt::ControlModifier));
}

void Areas::release(const input::PointerEvent& event) {
    if (!drag_.active()) return;
    if (event.kind == input::Kind::Release) drag(event);
    const grid::Combination how = drag_.how();
    const auto area = drag_.release(canvas_.px_mm());
    if (area)
        Q_EMIT drawn(*area);
    else
        Q_EMIT clicked(how);
}

void Areas::cancel() {
    if (!drag_.active()) return;
    drag_.cancel();
    Q_EMIT cancelled();
}

bool Areas::key(const QKeyEvent& event) {
    if (event.type() != QEvent::KeyPress || event.key() != Qt::Key_Escape || !form_) return false;
    if (drag_.active()) {
        cancel();
    } else {
        draw_next(std::nullopt);
        Q_EMIT left();
    }
    return true;
}

void Areas::draw(const view::Overlay& overlay) {
    if (drag_.active()) overlay.painter.draw_loop(drag_.outline_mm(), overlay.canvas, 1.0F);
}

}  // namespace pastoso::interactions
