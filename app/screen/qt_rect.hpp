// Rectangles of cells in Qt's terms.
#pragma once

#include "grid/shape.hpp"

#include <QRect>

namespace pastoso::screen {

inline QRect qt_rect(const grid::Rect& cells) {
    return {cells.x0, cells.y0, cells.width(), cells.height()};
}

inline grid::Rect cell_rect(const QRect& rect) {
    return {rect.x(), rect.y(), rect.x() + rect.width(), rect.y() + rect.height()};
}

}  // namespace pastoso::screen
