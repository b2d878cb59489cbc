// Which pixels of the window show these cells.
#pragma once

#include "screen/view_transform.hpp"

#include <QRegion>

namespace pastoso::screen {

/// The device pixels in whose picture a rectangle of cells has a part, those included whose splines
/// reach it. Of a canvas that is turned askew they are cut into strips, or a long row of cells would
/// have the whole window shaded.
QRegion damaged_pixels(const ViewTransform& view, const QRect& cells);
QRegion damaged_pixels(const ViewTransform& view, const QRegion& cells);

}  // namespace pastoso::screen
