// A finger on a screen.
#pragma once

#include <QPointF>

namespace pastoso::input {

/// One that is down, on the view in pixels of the layout.
struct Finger {
    int id = 0;  ///< no other one's while it is down
    QPointF place;
};

}  // namespace pastoso::input
