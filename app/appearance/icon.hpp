// The icons of the window: one family of line drawings, 16 pixels of the layout wide at first, sharp on
// every screen and in the colours of the theme. They lie in resources/icons as NAME.svg, drawn in black.
#pragma once

#include <QIcon>

class QColor;
class QPainter;
class QRectF;

namespace pastoso::appearance {

inline constexpr int kIconSide = 16;

/// For buttons and menus: in the colour of their text, faint where they are disabled, and so after a
/// change of the theme too. Empty where there is no such file.
QIcon icon(const QString& name);

/// Draws an icon into the middle of a place.
void draw_icon(QPainter& painter, const QRectF& place, const QString& name, const QColor& colour);

}  // namespace pastoso::appearance
