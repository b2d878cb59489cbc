// Marks on a colour wheel, seen on any colour.
#pragma once

#include "tools/colour_models.hpp"

#include <QColor>

class QPainter;
class QPointF;

namespace pastoso::panels {

/// A mark of a hue that goes with another reaches so far from its middle, in units of the window.
inline constexpr double kHueMark_px = 5.5;

QColor mark_colour(const tools::Channels& oklch);

/// A ring: what is chosen.
void paint_mark(QPainter& painter, const QPointF& place, const QColor& colour);

/// A diamond: a hue that goes with it.
void paint_hue_mark(QPainter& painter, const QPointF& place, const QColor& colour);

}  // namespace pastoso::panels
