// Where things lie around a middle, and a window around a point of the screen.
#pragma once

#include <vector>

#include <QPointF>
#include <QRect>

namespace pastoso::panels {

/// `count` places on an arc, the first and the last on its ends, or all evenly around where the ends
/// meet. Angles clockwise from the right.
std::vector<QPointF> ring_places(int count, double radius, double from_deg, double to_deg);

/// The corner of a window of that size around the point, moved so that all of it is on the screen.
QPoint corner_on_screen(const QPoint& middle, const QSize& size, const QRect& screen);

}  // namespace pastoso::panels
