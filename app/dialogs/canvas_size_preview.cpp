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
    : QWidget(parent), picture_(picture), size_mm_(size_mm) {
    setMinimumSize(160, 130);
}

void CanvasSizePreview::show_margins(const tools::Margins& margins) {
    margins_ = margins;
    update();
}

void CanvasSizePreview::paintEvent(QPaintEvent*) {
    const QRectF before(QPointF(0.0, 0.0), size_mm_);
    const QRectF after =
        before.adjusted(-margins_.left_mm, -margins_.top_mm, margins_.right_mm, margins_.bottom_mm);
    const QRectF room = QRectF(rect()).adjusted(kRoom_px, kRoom_px, -kRoom_px, -kRoom_px);
    const QTransform place = fitting(before.united(after), room);
    const QRectF before_px = place.mapRect(before), after_px = place.mapRect(after);
    QPainter painter(this);
    painter.setRenderHint(QPainter::SmoothPixmapTransform);
    painter.fillRect(after_px, appearance::shown(kBareCanvas));
    painter.fillRect(before_px, appearance::shown(kBareCanvas));
    painter.drawImage(before_px, appearance::shown(picture_));
    QPainterPath cut;
    cut.addRect(before_px);
    QPainterPath kept;
    kept.addRect(after_px);
    painter.fillPath(cut.subtracted(kept), kCutOff);
    painter.setPen(QPen(kOldEdge, 1.0, Qt::DashLine));
    painter.drawRect(before_px);
    painter.setPen(QPen(kNewEdge, 2.0));
    painter.drawRect(after_px);
}

}  // namespace pastoso::dialogs
