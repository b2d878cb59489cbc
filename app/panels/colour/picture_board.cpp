#include "panels/colour/picture_board.hpp"

#include "appearance/said_value.hpp"
#include "appearance/screen_colours.hpp"
#include "appearance/theme.hpp"
#include "panels/parts/section.hpp"

#include <algorithm>
#include <cmath>

#include <QApplication>
#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>

namespace pastoso::panels {
namespace {

constexpr double kZoomStep = 1.25;
constexpr double kMostZoom = 32.0;

}  // namespace

PictureBoard::PictureBoard(QWidget* parent) : QWidget(parent) {
    appearance::say_as(*this, QAccessible::Graphic);
    appearance::say_value(*this, tr("no picture"));
    setCursor(Qt::CrossCursor);
    connect(&appearance::screen_colours(), &appearance::ScreenColours::changed, this,
            [this] { shown_ = appearance::shown(picture_); });
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Expanding);
    keep_keys_for_canvas(this);
    keep_own_keys(this, {Qt::Key_Plus, Qt::Key_Minus, Qt::Key_0, Qt::Key_Left, Qt::Key_Right, Qt::Key_Up,
                         Qt::Key_Down});
}

void PictureBoard::show_picture(const QImage& picture) {
    picture_ = picture;
    shown_ = appearance::shown(picture_);
    appearance::say_value(*this,
                          picture_.isNull()
                              ? tr("no picture")
                              : tr("%1 \u00d7 %2 pixels").arg(picture_.width()).arg(picture_.height()));
    fit();
}

double PictureBoard::fitting_zoom() const {
    if (picture_.isNull()) return 1.0;
    return std::min(1.0 * width() / picture_.width(), 1.0 * height() / picture_.height());
}

void PictureBoard::fit() {
    fitted_ = true;
    zoom_ = fitting_zoom();
    corner_ = 0.5 * QPointF(width() - zoom_ * picture_.width(), height() - zoom_ * picture_.height());
    update();
}

/// Not farther than all of it is seen.
void PictureBoard::zoom_about(const QPointF& position, double factor) {
    if (picture_.isNull()) return;
    const double zoom = std::min(kMostZoom, zoom_ * factor);
    if (zoom <= fitting_zoom()) return fit();
    corner_ = position - (position - corner_) * (zoom / zoom_);
    zoom_ = zoom;
    fitted_ = false;
    move_by({});
}

/// Its middle stays in sight.
void PictureBoard::move_by(const QPointF& distance) {
    if (fitted_) return;
    const auto kept = [](double corner, double size, double room) {
        return std::clamp(corner, std::min(0.5 * room, room - size), std::max(0.5 * room - size, 0.0));
    };
    corner_ += distance;
    corner_ = {kept(corner_.x(), zoom_ * picture_.width(), width()),
               kept(corner_.y(), zoom_ * picture_.height(), height())};
    update();
}

QColor PictureBoard::colour_at(const QPointF& position) const {
    const QPointF pixel = pixel_at(position);
    const QPoint whole(static_cast<int>(std::floor(pixel.x())), static_cast<int>(std::floor(pixel.y())));
    if (!picture_.valid(whole)) return {};
    return picture_.pixelColor(whole);
}

void PictureBoard::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    painter.fillRect(rect(), appearance::colours().ground);
    if (picture_.isNull()) {
        painter.setPen(palette().text().color());
        painter.drawText(
            rect().adjusted(8, 8, -8, -8), Qt::AlignCenter | Qt::TextWordWrap,
            tr("A picture that you choose to trace lies here, to look at and to pick colours "
               "from, and below the paint."));
    } else {
        painter.setRenderHint(QPainter::SmoothPixmapTransform, zoom_ < 4.0);
        painter.drawImage(QRectF(corner_, zoom_ * QSizeF(picture_.size())), shown_);
    }
    if (!hasFocus()) return;
    painter.setPen(appearance::colours().focus);
    painter.drawRect(rect().adjusted(0, 0, -1, -1));
}

void PictureBoard::resizeEvent(QResizeEvent*) {
    if (fitted_) fit();
    move_by({});
}

void PictureBoard::mousePressEvent(QMouseEvent* event) {
    pressed_ = dragged_to_ = event->position();
    dragging_ = event->button() == Qt::MiddleButton;
}

void PictureBoard::mouseMoveEvent(QMouseEvent* event) {
    if (event->buttons() == Qt::NoButton) return;
    const QPointF way = event->position() - pressed_;
    dragging_ = dragging_ || way.manhattanLength() >= QApplication::startDragDistance();
    if (!dragging_) return;
    move_by(event->position() - dragged_to_);
    dragged_to_ = event->position();
}

void PictureBoard::mouseReleaseEvent(QMouseEvent* event) {
    const QColor colour = colour_at(event->position());
    if (!dragging_ && event->button() == Qt::LeftButton && colour.isValid())
        Q_EMIT colour_picked(colour);
}

/// The second press of two clicks picks as the first did.
void PictureBoard::mouseDoubleClickEvent(QMouseEvent* event) {
    mousePressEvent(event);
}

void PictureBoard::wheelEvent(QWheelEvent* event) {
    constexpr double kNotch = 120.0;
    zoom_about(event->position(), std::pow(kZoomStep, event->angleDelta().y() / kNotch));
    event->accept();
}

void PictureBoard::keyPressEvent(QKeyEvent* event) {
    constexpr double kStep = 24.0;
    const QPointF middle = 0.5 * QPointF(width(), height());
    switch (event->key()) {
        case Qt::Key_Plus:
            return zoom_about(middle, kZoomStep);
        case Qt::Key_Minus:
            return zoom_about(middle, 1.0 / kZoomStep);
        case Qt::Key_0:
            return fit();
        case Qt::Key_Left:
            return move_by({kStep, 0.0});
        case Qt::Key_Right:
            return move_by({-kStep, 0.0});
        case Qt::Key_Up:
            return move_by({0.0, kStep});
        case Qt::Key_Down:
            return move_by({0.0, -kStep});
        default:
            QWidget::keyPressEvent(event);
    }
}

}  // namespace pastoso::panels
