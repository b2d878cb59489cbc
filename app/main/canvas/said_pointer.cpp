#include "main/canvas/said_pointer.hpp"

#include "appearance/said_value.hpp"

namespace pastoso::main {

void say_pointer(view::CanvasView& view) {
    const auto say_away = [&view] {
        appearance::say_value(view, QObject::tr("The brush is not over it"));
    };
    appearance::say_as(view, QAccessible::Canvas);
    say_away();
    QObject::connect(&view, &view::CanvasView::pointer_left, &view, say_away);
    QObject::connect(&view, &view::CanvasView::pointer_moved, &view, [&view](const QPointF& place_mm) {
        appearance::say_value(
            view,
            QObject::tr("Brush at %1, %2 mm").arg(place_mm.x(), 0, 'f', 0).arg(place_mm.y(), 0, 'f', 0));
    });
}

}  // namespace pastoso::main
