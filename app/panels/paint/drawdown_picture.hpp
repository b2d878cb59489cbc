// How well paint hides, as colour charts and tubes show it.
#pragma once

#include "tools/drawdown.hpp"

class QColor;
class QPainter;
class QRectF;

namespace pastoso::panels {

/// Over white above and over black below, from the film in hand on the left to a thin one.
void draw_drawdown(QPainter& painter, const QRectF& place, const tools::Drawdown& drawdown);

/// The square that stands on tubes: empty, crossed by a line, half filled or filled.
void draw_hiding_mark(QPainter& painter, const QRectF& place, pigment::Hiding hiding, const QColor& ink);

}  // namespace pastoso::panels
