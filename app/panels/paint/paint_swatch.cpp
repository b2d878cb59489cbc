#include "panels/paint/paint_swatch.hpp"

#include "panels/parts/section.hpp"

#include <QFontMetrics>
#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>

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
    const bool marked = hasFocus() || underMouse() || isDown();
    painter.setPen(marked ? QPen(palette().highlight(), 2.0) : QPen(QColor(0, 0, 0, 140)));
    painter.setBrush(colour_);
    painter.drawRoundedRect(QRectF(rect()).adjusted(1.0, 1.0, -1.0, -1.0), 3.0, 3.0);
}

}  // namespace pastoso::panels
