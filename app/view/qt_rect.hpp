// Rectangles of cells in Qt's terms.
#pragma once

#include "grid/shape.hpp"

#include <QRect>

namespace pastoso::view {

inline QRect qt_rect(const grid::Rect& cells) {
    return {cells.x0, cells.y0, cells.width(), cells.height()};
}

}  // namespace pastoso::view
