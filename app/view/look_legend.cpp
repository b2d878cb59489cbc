#include "view/look_legend.hpp"

#include "appearance/screen_colours.hpp"
#include "appearance/shown_number.hpp"
#include "appearance/theme.hpp"

#include <algorithm>
#include <cmath>

#include <QPainter>

namespace pastoso::view {
namespace {

using appearance::shown_number;

constexpr int kMargin = 10, kGap = 8, kBarWidth = 220, kBarHeight = 12;

QColor colour(const screen::Rgb& rgb) {
    return appearance::shown(QColor::fromRgbF(rgb[0], rgb[1], rgb[2]));
}

/// Of the marks below the bar, the first at its left end, the last at its right.
QStringList marks(screen::Look look, double scale_top_mm) {
    if (look == screen::Look::Wet) return {shown_number(0.01), shown_number(0.1), shown_number(1.0)};
    if (look == screen::Look::Height)
        return {QStringLiteral("0"), shown_number(0.5 * scale_top_mm),
                LookLegend::tr("%1 mm").arg(shown_number(scale_top_mm))};
    return {};
}

/// Of the thickness on the scale of the tint, 0 to 1.
double wet_place(double wet_mm) {
    return screen::wet_tint(wet_mm) / screen::kFullTint;
}

}  // namespace

QString look_words(screen::Look look) {
    switch (look) {
        case screen::Look::Lit:
            return {};
        case screen::Look::Wet:
            return LookLegend::tr("Wet paint");
        case screen::Look::Height:
            return LookLegend::tr("Height of the paint");
        case screen::Look::Normals:
            return LookLegend::tr("Slopes of the surface");
        case screen::Look::Flat:
            return LookLegend::tr("Flat colour");
    }
    return {};
}

LookLegend::LookLegend(QWidget* parent) : QWidget(parent) {
    setObjectName(QStringLiteral("look_legend"));
    setAttribute(Qt::WA_TransparentForMouseEvents);
    hide();
}

void LookLegend::show_look(screen::Look look, double scale_top_mm) {
    look_ = look;
    lines_ = QStringList(look_words(look)) + marks(look, scale_top_mm);
    setVisible(look != screen::Look::Lit);
    const bool has_bar = lines_.size() > 1;
    const int line = fontMetrics().height();
    const int width = has_bar ? kBarWidth : fontMetrics().horizontalAdvance(lines_.front());
    resize(width + 2 * kMargin, 2 * kMargin + line + (has_bar ? kGap + kBarHeight + 2 + line : 0));
    update();
}

void LookLegend::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    const appearance::ThemeColours& colours = appearance::colours();
    QColor ground = colours.window;
    ground.setAlpha(225);
    painter.setPen(colours.line);
    painter.setBrush(ground);
    painter.drawRoundedRect(QRectF(rect()).adjusted(0.5, 0.5, -0.5, -0.5), 5.0, 5.0);
    painter.setPen(colours.text);
    const int line = fontMetrics().height();
    painter.drawText(QRect(kMargin, kMargin, width() - 2 * kMargin, line), Qt::AlignLeft,
                     lines_.front());
    const QRect bar(kMargin, kMargin + line + kGap, kBarWidth, kBarHeight);
    if (look_ == screen::Look::Height) paint_heights(painter, bar);
    if (look_ == screen::Look::Wet) paint_wetness(painter, bar);
}

void LookLegend::paint_heights(QPainter& painter, const QRect& bar) const {
    for (int step = 0; step < screen::kHeightSteps; ++step)
        painter.fillRect(QRectF(bar.x() + bar.width() * step / double(screen::kHeightSteps), bar.y(),
                                bar.width() / double(screen::kHeightSteps), bar.height()),
                         colour(screen::kHeightColours[step]));
    const QRect below(bar.x(), bar.bottom() + 3, bar.width(), fontMetrics().height());
    painter.drawText(below, Qt::AlignLeft, lines_[1]);
    painter.drawText(below, Qt::AlignHCenter, lines_[2]);
    painter.drawText(below, Qt::AlignRight, lines_[3]);
}

void LookLegend::paint_wetness(QPainter& painter, const QRect& bar) const {
    QLinearGradient tint(bar.topLeft(), bar.topRight());
    QColor dry(Qt::gray), wet = colour(screen::kWetTint);
    tint.setColorAt(0.0, dry);
    tint.setColorAt(1.0, wet);
    painter.fillRect(bar, tint);
    for (int mark = 1; mark < lines_.size(); ++mark) {
        const double wet_mm = std::pow(10.0, mark - 3);
        const double x = bar.x() + bar.width() * wet_place(wet_mm);
        const QString text = mark + 1 == lines_.size() ? tr("%1 mm").arg(lines_[mark]) : lines_[mark];
        const int half = fontMetrics().horizontalAdvance(text) / 2;
        const double left = std::clamp(x - half, double(bar.x()), double(bar.right() - 2 * half));
        painter.drawLine(QPointF(x, bar.y()), QPointF(x, bar.bottom() + 3));
        painter.drawText(QPointF(left, bar.bottom() + 3 + fontMetrics().ascent()), text);
    }
}

}  // namespace pastoso::view
