#include "dialogs/canvas_size_preview.hpp"

#include "appearance/screen_colours.hpp"

#include <algorithm>

#include <QPainter>
#include <QPainterPath>

namespace pastoso::dialogs {
namespace {

constexpr QColor kBareCanvas(233, 230, 222);
constexpr QColor kNewEdge(104, 138, 172);
constexpr QColor kOldEdge(90, 90, 94);
constexpr QColor kCutOff(28, 28, 30, 190);
constexpr double kRoom_px = 6.0;

/// From millimetres to the widget, so that all of the rectangle is seen in its middle.
QTransform fitting(const QRectF& all_mm, const QRectF& room) {
    const double scale = std::min(room.width() / all_mm.width(), room.height() / all_mm.height());
    const QPointF corner = room.center() - scale * all_mm.center();
    return {scale, 0.0, 0.0, scale, corner.x(), corner.y()};
}

}  // namespace

CanvasSizePreview::CanvasSizePreview(const QImage& picture, const QSizeF& size_mm, QWidget* parent)
    : QWidget(parent), picture_(picture), before_mm_(QPointF(0.0, 0.0), size_mm), after_mm_(before_mm_) {
    setMinimumSize(160, 130);
}

void CanvasSizePreview::show_margins(const tools::Margins& margins) {
    after_mm_ =
        before_mm_.adjusted(-margins.left_mm, -margins.top_mm, margins.right_mm, margins.bottom_mm);
    update();
}

void CanvasSizePreview::show_rotated(const QSizeF& size_mm, double turn_deg) {
    after_mm_ = QRectF(QPointF(0.0, 0.0), size_mm);
    after_mm_.moveCenter(before_mm_.center());
    turn_deg_ = turn_deg;
    update();
}

void CanvasSizePreview::paintEvent(QPaintEvent*) {
    const QPointF middle = before_mm_.center();
    const QTransform turn = QTransform()
                                .translate(middle.x(), middle.y())
                                .rotate(turn_deg_)
                                .translate(-middle.x(), -middle.y());
    const QRectF room = QRectF(rect()).adjusted(kRoom_px, kRoom_px, -kRoom_px, -kRoom_px);
    const QTransform place = fitting(turn.mapRect(before_mm_).united(after_mm_), room);
    const QRectF after_px = place.mapRect(after_mm_);
    QPainterPath before, after;
    before.addPolygon((turn * place).map(QPolygonF(before_mm_)));
    after.addRect(after_px);
    QPainter painter(this);
    painter.setRenderHint(QPainter::SmoothPixmapTransform);
    painter.setRenderHint(QPainter::Antialiasing, turn_deg_ != 0.0);
    painter.fillRect(after_px, appearance::shown(kBareCanvas));
    painter.fillPath(before, appearance::shown(kBareCanvas));
    painter.setTransform(turn * place);
    painter.drawImage(before_mm_, appearance::shown(picture_));
    painter.resetTransform();
    painter.fillPath(before.subtracted(after), kCutOff);
    painter.strokePath(before, QPen(kOldEdge, 1.0, Qt::DashLine));
    painter.setPen(QPen(kNewEdge, 2.0));
    painter.drawRect(after_px);
}

}  // namespace pastoso::dialogs
