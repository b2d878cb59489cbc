// A mouse over a canvas, with keys held down.
#pragma once

#include "view/canvas_view.hpp"

#include <QApplication>
#include <QMouseEvent>
#include <glm/vec2.hpp>

namespace pastoso::tests {

inline void send_mouse(view::CanvasView& canvas, QEvent::Type type, const glm::dvec2& place_mm,
                       Qt::KeyboardModifiers keys) {
    const bool moves = type == QEvent::MouseMove, up = type == QEvent::MouseButtonRelease;
    const QPointF position = canvas.widget_position(place_mm);
    QMouseEvent event(type, position, canvas.mapToGlobal(position),
                      moves ? Qt::NoButton : Qt::LeftButton, up ? Qt::NoButton : Qt::LeftButton, keys);
    QApplication::sendEvent(&canvas, &event);
}

}  // namespace pastoso::tests
