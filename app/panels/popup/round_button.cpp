#include "panels/popup/round_button.hpp"

#include "appearance/screen_colours.hpp"

#include <cmath>

#include <QKeyEvent>
#include <QPainter>
#include <QPainterPath>

namespace pastoso::panels {

RoundButton::RoundButton(int diameter, QWidget* parent) : QAbstractButton(parent) {
    setFixedSize(diameter, diameter);
    setFocusPolicy(Qt::TabFocus);
    setAttribute(Qt::WA_Hover);
}

void RoundButton::show_colour(const QColor& colour, const QString& words) {
    colour_ = colour;
    show_words(words);
}

void RoundButton::show_picture(const QImage& picture) {
    picture_ = picture;
    update();
}

void RoundButton::show_words(const QString& words) {
    setToolTip(words);
    setAccessibleName(words);
    update();
}

void RoundButton::move_middle(const QPointF& place) {
    move((place - 0.5 * QPointF(width(), height())).toPoint());
}

bool RoundButton::hitButton(const QPoint& place) const {
    const QPointF away = place - 0.5 * QPointF(width(), height());
    return std::hypot(away.x(), away.y()) <= 0.5 * width();
}

void RoundButton::focusInEvent(QFocusEvent* event) {
    QAbstractButton::focusInEvent(event);
    update();
}

/// Arrows are its parent's: they go around a ring.
void RoundButton::keyPressEvent(QKeyEvent* event) {
    const int key = event->key();
    if (key == Qt::Key_Left || key == Qt::Key_Right || key == Qt::Key_Up || key == Qt::Key_Down)
        event->ignore();
    else
        QAbstractButton::keyPressEvent(event);
}

void RoundButton::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    painter.setRenderHints(QPainter::Antialiasing | QPainter::SmoothPixmapTransform);
    const QRectF disc = QRectF(rect()).adjusted(2.0, 2.0, -2.0, -2.0);
    paint_face(painter, disc);
    const bool can = isEnabled() && focusPolicy() != Qt::NoFocus;
    const bool marked = can && (hasFocus() || underMouse() || isDown());
    const QColor rim =
        marked || isChecked() ? palette().color(QPalette::Highlight) : QColor(0, 0, 0, 140);
    painter.setPen(QPen(rim, marked ? 3.0 : isChecked() ? 2.0 : 1.0));
    painter.setBrush(Qt::NoBrush);
    painter.drawEllipse(disc);
}

void RoundButton::paint_face(QPainter& painter, const QRectF& disc) {
    painter.setPen(Qt::NoPen);
    painter.setBrush(colour_.isValid() ? appearance::shown(colour_) : palette().color(QPalette::Button));
    painter.drawEllipse(disc);
    QPainterPath clip;
    clip.addEllipse(disc);
    if (!picture_.isNull()) {
        painter.setClipPath(clip);
        painter.drawImage(disc, appearance::shown(picture_));
        painter.setClipping(false);
    } else if (!icon().isNull()) {
        const int side = static_cast<int>(0.5 * disc.width());
        QRect place(0, 0, side, side);
        place.moveCenter(disc.center().toPoint());
        icon().paint(&painter, place, Qt::AlignCenter, isEnabled() ? QIcon::Normal : QIcon::Disabled);
    } else if (!text().isEmpty()) {
        painter.setPen(
            palette().color(isEnabled() ? QPalette::Active : QPalette::Disabled, QPalette::ButtonText));
        painter.drawText(disc, Qt::AlignCenter, text());
    }
}

}  // namespace pastoso::panels
