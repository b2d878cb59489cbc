#include "panels/paint/paint_swatch.hpp"

#include "appearance/screen_colours.hpp"
#include "panels/paint/drawdown_picture.hpp"
#include "panels/parts/section.hpp"

#include <QFontMetrics>
#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>
#include <QPainterPath>

namespace pastoso::panels {

PaintSwatch::PaintSwatch(QWidget* parent) : QPushButton(parent) {
    setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Fixed);
    keep_keys_for_canvas(this);
    keep_own_keys(this, {Qt::Key_Delete});
}

void PaintSwatch::show_paint(const QColor& colour, const QString& words) {
    colour_ = colour;
    setToolTip(words);
    setAccessibleName(words);
    update();
}

void PaintSwatch::show_drawdown(const tools::Drawdown& drawdown) {
    drawdown_ = drawdown;
    update();
}

QSize PaintSwatch::sizeHint() const {
    const int side = fontMetrics().height() + 6;
    return {side, side};
}

void PaintSwatch::mousePressEvent(QMouseEvent* event) {
    if (event->button() == Qt::RightButton) return void(Q_EMIT removal_wanted());
    QPushButton::mousePressEvent(event);
}

void PaintSwatch::keyPressEvent(QKeyEvent* event) {
    if (event->key() == Qt::Key_Delete) return void(Q_EMIT removal_wanted());
    QPushButton::keyPressEvent(event);
}

void PaintSwatch::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    const QRectF frame = QRectF(rect()).adjusted(1.0, 1.0, -1.0, -1.0);
    QPainterPath outline;
    outline.addRoundedRect(frame, 3.0, 3.0);
    painter.fillPath(outline, appearance::shown(colour_));
    if (drawdown_) {
        constexpr double kMark_px = 8.0, kMargin_px = 5.0;
        painter.setClipPath(outline);
        draw_drawdown(painter, frame.adjusted(0.5 * frame.width(), 0.0, 0.0, 0.0), *drawdown_);
        painter.setClipping(false);
        const QPointF corner(frame.left() + kMargin_px, frame.center().y() - 0.5 * kMark_px);
        const QColor ink = colour_.lightness() > 128 ? QColor(20, 20, 20) : QColor(240, 240, 240);
        draw_hiding_mark(painter, {corner, QSizeF(kMark_px, kMark_px)}, drawdown_->hiding, ink);
    }
    const bool marked = hasFocus() || underMouse() || isDown();
    painter.setPen(marked ? QPen(palette().highlight(), 2.0) : QPen(QColor(0, 0, 0, 140)));
    painter.drawPath(outline);
}

}  // namespace pastoso::panels
