// A widget's pixels on the screen, and what lies below and beside the canvas in it.
#pragma once

#include "grid/shape.hpp"
#include "screen/look.hpp"
#include "screen/view_transform.hpp"

#include <QSize>
#include <QWidget>

namespace pastoso::screen {

/// Its size in device pixels.
QSize window_px(const QWidget& widget);

/// The canvas's cells that a window shows.
grid::Rect seen_cells(const ViewTransform& view, const QSize& window_px, const grid::Shape& canvas);

/// Around the canvas, encoded.
Rgb ground_colour();

}  // namespace pastoso::screen
