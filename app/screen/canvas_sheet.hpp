// The canvas as pixels of its own orientation.
#pragma once

#include "screen/view_transform.hpp"
#include "shade/render.hpp"

#include <QRect>
#include <QTransform>

namespace pastoso::screen {

/// As large as the canvas is seen. Where it stands upright in the window, the sheet's pixels are the
/// window's.
struct CanvasSheet {
    shade::Lattice lattice;
    QTransform to_window;  ///< from its pixels

    CanvasSheet(const grid::Shape& canvas, const ViewTransform& view);

    /// The pixels below a rectangle of the window.
    grid::Rect pixels_below(const QRect& window) const;
};

}  // namespace pastoso::screen
