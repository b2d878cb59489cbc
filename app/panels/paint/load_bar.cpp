#include "panels/paint/load_bar.hpp"

#include "appearance/screen_colours.hpp"
#include "panels/paint/swatch_colours.hpp"

#include <algorithm>

#include <QFontMetrics>
#include <QPainter>
#include <QPainterPath>

namespace pastoso::panels {
namespace {

/// A brush that spills holds more than its capacity.
constexpr double kFullest = 1.2;

}  // namespace

LoadBar::LoadBar(QWidget* parent) : QWidget(parent) {
    setObjectName(QStringLiteral("load_bar"));
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    setToolTip(tr("The paint in the brush, across its width: how full it is, and of which colour"));
}

QSize LoadBar::sizeHint() const {
    return {8 * fontMetrics().height(), 2 * fontMetrics().height()};
}

void LoadBar::show_load(const brush::LoadProfile& load) {
    if (load == load_) return;
    load_ = load;
    update();
}

void LoadBar::show_swatches(const tools::SwatchView& view) {
    view_ = view;
    update();
}

void LoadBar::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    const QRectF frame = QRectF(rect()).adjusted(0.5, 0.5, -0.5, -0.5);
    QPainterPath outline;
    outline.addRoundedRect(frame, 3.0, 3.0);
    painter.setClipPath(outline);
    painter.fillRect(rect(), palette().base());
    painter.setRenderHint(QPainter::Antialiasing, false);
    constexpr int kCount = brush::LoadProfile::kStripes;
    for (int i = 0; i < kCount; ++i) {
        const auto& stripe = load_.stripes[static_cast<std::size_t>(i)];
        const int left = width() * i / kCount, right = width() * (i + 1) / kCount;
        const int filled = static_cast<int>(height() * std::min(stripe.fill / kFullest, 1.0) + 0.5);
        painter.fillRect(left, height() - filled, right - left, filled,
                         appearance::shown(shown_colour(stripe.paint, view_)));
    }
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setClipping(false);
    painter.strokePath(outline, QPen(QColor(0, 0, 0, 140)));
}

}  // namespace pastoso::panels
