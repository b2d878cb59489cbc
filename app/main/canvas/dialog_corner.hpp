// Where a dialog stands whose choice is seen on the canvas.
#pragma once

#include <QDialog>

namespace pastoso::main {

inline constexpr int kFromEdge_px = 16;

/// Shows it in a corner of the view, where it hides little.
inline void show_in_corner(QDialog& dialog, const QWidget& view) {
    const int y = view.height() - dialog.sizeHint().height() - kFromEdge_px;
    dialog.move(view.mapToGlobal(QPoint(kFromEdge_px, y)));
    dialog.show();
}

/// Where a dialog of that size hides nothing of what is taken in a view: its upper left corner in the
/// first corner of the view that is free, at the side that is farther from what is taken, the lower one
/// first. Where there is no room, in that one.
inline QPoint place_beside(const QRect& taken, const QSize& size, const QSize& view) {
    const int right = view.width() - size.width() - kFromEdge_px;
    const int low = view.height() - size.height() - kFromEdge_px;
    const bool is_left = 2 * taken.center().x() < view.width();
    const int far = is_left ? right : kFromEdge_px, near = is_left ? kFromEdge_px : right;
    for (const QPoint& corner :
         {QPoint(far, low), QPoint(far, kFromEdge_px), QPoint(near, low), QPoint(near, kFromEdge_px)})
        if (!QRect(corner, size).intersects(taken)) return corner;
    return {far, low};
}

}  // namespace pastoso::main
