// Shapes of the pointer over frames and their handles.
#pragma once

#include <QCursor>
#include <QPointF>

namespace pastoso::appearance {

/// For a handle that scales, by the way to it from the middle of its frame, on the screen.
Qt::CursorShape scaling_cursor(const QPointF& way);

/// For one that turns: a bow with a point at both ends.
const QCursor& turning_cursor();

}  // namespace pastoso::appearance
