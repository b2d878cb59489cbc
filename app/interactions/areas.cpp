#include "interactions/areas.hpp"

#include "interactions/event_combination.hpp"
#include "interactions/event_place.hpp"

#include <QKeyEvent>

namespace pastoso::interactions {

using view::Took;

void Areas::draw_next(std::optional<AreaForm> form) {
    form_ = form;
    drag_.cancel();
    corners_.cancel();
    canvas_.refresh();
}

Took Areas::press(const input::PointerEvent& event) {
    if (!form_ || event.button != Qt::LeftButton) return Took::Nothing;
    if (form_ == AreaForm::Polygon) {
        click(event);
        return Took::Pointer;
    }
    drag_.press(*form_, place_mm(event), combination(event.modifiers));
    Q_EMIT begun(drag_.how());
    return Took::Pointer;
}

void Areas::click(const input::PointerEvent& event) {
    const glm::dvec2 place = place_mm(event);
    if (!corners_.active()) {
        corners_.begin(place, combination(event.modifiers));
        Q_EMIT begun(corners_.how());
    } else if (corners_.closes(place, canvas_.px_mm())) {
        close_polygon();
    } else {
        corners_.add(place);
    }
}

void Areas::close_polygon() {
    if (const auto area = corners_.close(canvas_.px_mm()))
        Q_EMIT drawn(*area);
    else
        Q_EMIT cancelled();
}

void Areas::take_corner_back() {
    corners_.take_back();
    if (!corners_.active()) Q_EMIT cancelled();
}

void Areas::drag(const input::PointerEvent& event) {
    hover(event);
    if (!drag_.active()) return;
    drag_.move(place_mm(event), canvas_.px_mm(), event.modifiers.testFlag(Qt::ControlModifier));
}

void Areas::hover(const input::PointerEvent& event) {
    if (corners_.active()) corners_.follow(place_mm(event));
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

/// Of a polygon the corner alone was not meant.
void Areas::cancel() {
    if (corners_.active())
        take_corner_back();
    else
        drop_outline();
}

void Areas::drop_outline() {
    if (!is_drawing()) return;
    drag_.cancel();
    corners_.cancel();
    Q_EMIT cancelled();
}

bool Areas::needs_key(const QKeyEvent& event) const {
    const bool ends = event.key() == Qt::Key_Return || event.key() == Qt::Key_Enter;
    return corners_.active() && (ends || event.key() == Qt::Key_Backspace);
}

bool Areas::key(const QKeyEvent& event) {
    if (event.type() != QEvent::KeyPress) return false;
    if (needs_key(event)) {
        if (event.key() == Qt::Key_Backspace)
            take_corner_back();
        else
            close_polygon();
        return true;
    }
    if (event.key() != Qt::Key_Escape || !form_) return false;
    if (is_drawing()) {
        drop_outline();
    } else {
        draw_next(std::nullopt);
        Q_EMIT left();
    }
    return true;
}

void Areas::draw(const view::Overlay& overlay) {
    if (drag_.active()) overlay.painter.draw_loop(drag_.outline_mm(), overlay.canvas, 1.0F);
    if (corners_.active()) overlay.painter.draw_loop(corners_.outline_mm(), overlay.canvas, 1.0F);
}

}  // namespace pastoso::interactions
