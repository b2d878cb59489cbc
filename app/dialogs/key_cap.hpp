// Keys drawn as the caps of a keyboard.
#pragma once

#include <QFontMetrics>
#include <QRect>
#include <QString>

class QPainter;

namespace pastoso::dialogs {

/// In a row of that height.
int key_cap_width(const QFontMetrics& metrics, const QString& key, const QRect& row);

/// From `left` on.
void draw_key_cap(QPainter& painter, const QString& key, const QRect& row, int left, bool faint);

}  // namespace pastoso::dialogs
