// Marks on a colour wheel, seen on any colour.
#pragma once

#include "tools/colour_models.hpp"

#include <QColor>

class QPainter;
class QPointF;
class QPolygonF;

namespace pastoso::panels {

/// A mark of a hue that goes with another reaches so far from its middle, in units of the window.
inline constexpr double kHueMark_px = 5.5;

QColor mark_colour(const tools::Channels& oklch);

/// A ring: what is chosen.
void paint_mark(QPainter& painter, const QPointF& place, const QColor& colour);

/// A diamond: a hue that goes with it.
void paint_hue_mark(QPainter& painter, const QPointF& place, const QColor& colour);

/// Makes what is beyond the outline of a mask faint, on a disc of that radius.
void paint_veil(QPainter& painter, const QPointF& middle, double radius, const QPolygonF& outline,
                QColor colour);

/// The outline of a mask, with a dot at each of its first `corners`.
void paint_mask_line(QPainter& painter, const QPolygonF& outline, int corners, const QColor& colour);

}  // namespace pastoso::panels
