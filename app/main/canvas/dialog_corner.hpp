// Where a dialog stands whose choice is seen on the canvas.
#pragma once

#include <QDialog>

namespace pastoso::main {

/// Shows it in a corner of the view, where it hides little.
inline void show_in_corner(QDialog& dialog, const QWidget& view) {
    constexpr int kMargin_px = 16;
    const int y = view.height() - dialog.sizeHint().height() - kMargin_px;
    dialog.move(view.mapToGlobal(QPoint(kMargin_px, y)));
    dialog.show();
}

}  // namespace pastoso::main
