#include "dialogs/key_cap.hpp"

#include "appearance/theme.hpp"

#include <algorithm>

#include <QPainter>

namespace pastoso::dialogs {
namespace {

constexpr int kPadding = 7;

}  // namespace

int key_cap_width(const QFontMetrics& metrics, const QString& key, const QRect& row) {
    return std::max(metrics.horizontalAdvance(key) + 2 * kPadding, row.height() - 8);
}

void draw_key_cap(QPainter& painter, const QString& key, const QRect& row, int left, bool faint) {
    const int width = key_cap_width(painter.fontMetrics(), key, row);
    const QRectF cap(left + 0.5, row.top() + 4.5, width - 1, row.height() - 9);
    const appearance::ThemeColours& colours = appearance::colours();
    QColor face = colours.window;
    if (faint) face.setAlphaF(0.5);
    painter.setPen(colours.line);
    painter.setBrush(face);
    painter.drawRoundedRect(cap, 4.0, 4.0);
    painter.setPen(faint ? colours.faint_text : colours.text);
    painter.drawText(cap, Qt::AlignCenter, key);
}

}  // namespace pastoso::dialogs
