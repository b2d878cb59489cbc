#include "panels/canvas/navigator_map.hpp"

#include "appearance/said_value.hpp"
#include "appearance/screen_colours.hpp"
#include "appearance/theme.hpp"
#include "panels/parts/section.hpp"

#include <QApplication>
#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>

namespace pastoso::panels {
namespace {

constexpr double kMargin_px = 6.0;

}  // namespace

NavigatorMap::NavigatorMap(QWidget* parent) : QWidget(parent) {
    appearance::say_as(*this, QAccessible::Graphic);
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Expanding);
    setCursor(Qt::PointingHandCursor);
    connect(&appearance::screen_colours(), &appearance::ScreenColours::changed, this,
            &NavigatorMap::fit_picture);
    keep_keys_for_canvas(this);
    keep_own_keys(this,
                  {Qt::Key_Left, Qt::Key_Right, Qt::Key_Up, Qt::Key_Down, Qt::Key_Plus, Qt::Key_Minus});
}

/// The largest rectangle of the canvas's proportions, in the middle.
QRectF NavigatorMap::canvas_place() const {
    const QSizeF room(std::max(1.0, width() - 2.0 * kMargin_px),
                      std::max(1.0, height() - 2.0 * kMargin_px));
    QRectF place(QPointF(0.0, 0.0), canvas_.scaled(room, Qt::KeepAspectRatio));
    place.moveCenter(QPointF(0.5 * width(), 0.5 * height()));
    return place;
}

QPointF NavigatorMap::widget_position(const QPointF& share) const {
    const QRectF place = canvas_place();
    return {place.left() + share.x() * place.width(), place.top() + share.y() * place.height()};
}

QPointF NavigatorMap::share_at(const QPointF& position) const {
    const QRectF place = canvas_place();
    return {(position.x() - place.left()) / place.width(),
            (position.y() - place.top()) / place.height()};
}

QPointF NavigatorMap::centre() const {
    return frame_.size() < 4 ? QPointF(0.5, 0.5) : 0.5 * (frame_[0] + frame_[2]);
}

void NavigatorMap::show_picture(const QImage& picture) {
    picture_ = picture;
    fit_picture();
}

/// Once for every picture: a frame that moves over it is drawn on what is there.
void NavigatorMap::fit_picture() {
    if (picture_.isNull()) return;
    const QSize size = (canvas_place().size() * devicePixelRatioF()).toSize();
    shown_ = QPixmap::fromImage(appearance::shown_in_painting(
        picture_.scaled(size, Qt::IgnoreAspectRatio, Qt::SmoothTransformation)));
    shown_.setDevicePixelRatio(devicePixelRatioF());
    update();
}

void NavigatorMap::show_frame(const QSizeF& canvas, const QPolygonF& corners) {
    if (canvas == canvas_ && corners == frame_) return;
    const bool other_canvas = canvas != canvas_;
    canvas_ = canvas;
    frame_ = corners;
    if (other_canvas) fit_picture();
    appearance::say_value(*this,
                          tr("The middle of the window is %1 % from the left and %2 % from the top")
                              .arg(100.0 * centre().x(), 0, 'f', 0)
                              .arg(100.0 * centre().y(), 0, 'f', 0));
    update();
}

void NavigatorMap::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    painter.fillRect(rect(), appearance::colours().ground);
    const QRectF place = canvas_place();
    if (!shown_.isNull()) painter.drawPixmap(place.topLeft(), shown_);
    if (frame_.size() == 4) {
        QPolygonF frame;
        for (const QPointF& corner : frame_)
            frame.append(widget_position(corner));
        painter.setRenderHint(QPainter::Antialiasing);
        painter.setBrush(Qt::NoBrush);
        painter.setPen(QPen(QColor(0, 0, 0, 150), 3.5));
        painter.drawPolygon(frame);
        painter.setPen(QPen(QColor(255, 255, 255, 220), 1.5));
        painter.drawPolygon(frame);
        // The window's upper edge: it tells a canvas that is turned from one that stands upright.
        painter.setPen(QPen(palette().highlight().color(), 2.5));
        painter.drawLine(frame[0], frame[1]);
    }
    if (!hasFocus()) return;
    painter.setRenderHint(QPainter::Antialiasing, false);
    painter.setPen(palette().highlight().color());
    painter.drawRect(rect().adjusted(0, 0, -1, -1));
}

void NavigatorMap::resizeEvent(QResizeEvent*) {
    fit_picture();
}

/// In the frame it takes hold of it where it is; beside it the frame comes to the pointer.
void NavigatorMap::mousePressEvent(QMouseEvent* event) {
    if (event->button() != Qt::LeftButton) return;
    held_ = true;
    dragged_ = false;
    pressed_ = event->position();
    const QPointF share = share_at(pressed_);
    const bool inside = frame_.containsPoint(share, Qt::OddEvenFill);
    grip_ = inside ? centre() - share : QPointF();
    if (!inside) Q_EMIT centre_wanted(share);
}

void NavigatorMap::mouseMoveEvent(QMouseEvent* event) {
    if (!held_) return;
    const QPointF way = event->position() - pressed_;
    dragged_ = dragged_ || way.manhattanLength() >= QApplication::startDragDistance();
    if (dragged_) Q_EMIT centre_wanted(share_at(event->position()) + grip_);
}

/// A click goes there, also within the frame.
void NavigatorMap::mouseReleaseEvent(QMouseEvent* event) {
    if (event->button() != Qt::LeftButton || !held_) return;
    held_ = false;
    if (!dragged_) Q_EMIT centre_wanted(share_at(event->position()));
}

void NavigatorMap::wheelEvent(QWheelEvent* event) {
    constexpr double kNotch = 120.0;
    Q_EMIT zoomed(event->angleDelta().y() / kNotch);
    event->accept();
}

/// By a tenth of the longer side, on the screen's axes as they lie on the canvas.
void NavigatorMap::step(const QPointF& way) {
    constexpr double kStep = 0.1;
    if (frame_.size() < 4) return;
    const QPointF across = frame_[1] - frame_[0], down = frame_[3] - frame_[0];
    Q_EMIT centre_wanted(centre() + kStep * (way.x() * across + way.y() * down));
}

void NavigatorMap::keyPressEvent(QKeyEvent* event) {
    switch (event->key()) {
        case Qt::Key_Left:
            return step({-1.0, 0.0});
        case Qt::Key_Right:
            return step({1.0, 0.0});
        case Qt::Key_Up:
            return step({0.0, -1.0});
        case Qt::Key_Down:
            return step({0.0, 1.0});
        case Qt::Key_Plus:
            return zoomed(1.0);
        case Qt::Key_Minus:
            return zoomed(-1.0);
        default:
            QWidget::keyPressEvent(event);
    }
}

}  // namespace pastoso::panels
