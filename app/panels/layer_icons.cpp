#include "panels/layer_icons.hpp"

#include <QApplication>
#include <QPainter>
#include <QPainterPath>
#include <QPalette>
#include <QPixmap>

namespace pastoso::panels {
namespace {

constexpr int kSide = 16;
constexpr double kLine = 1.4;

/// All on a square of 16 by 16, lines alone unless said.
QPainterPath eye_outline() {
    QPainterPath path(QPointF(1.5, 8.0));
    path.quadTo(8.0, 0.5, 14.5, 8.0);
    path.quadTo(8.0, 15.5, 1.5, 8.0);
    return path;
}

QPainterPath closed_eye() {
    QPainterPath path(QPointF(1.5, 7.0));
    path.quadTo(8.0, 13.5, 14.5, 7.0);
    for (const QLineF& lash :
         {QLineF(3.4, 9.2, 2.0, 11.4), QLineF(8.0, 10.3, 8.0, 13.0), QLineF(12.6, 9.2, 14.0, 11.4)}) {
        path.moveTo(lash.p1());
        path.lineTo(lash.p2());
    }
    return path;
}

QPainterPath lock_body() {
    QPainterPath path;
    path.addRoundedRect(QRectF(3.5, 7.0, 9.0, 7.0), 1.5, 1.5);
    return path;
}

QPainterPath shackle(bool open) {
    QPainterPath path(QPointF(5.3, 7.0));
    path.lineTo(5.3, 4.6);
    path.arcTo(QRectF(5.3, 1.9, 5.4, 5.4), 180.0, -180.0);
    if (!open) path.lineTo(10.7, 7.0);
    return path;
}

QPainterPath sheet(const QRectF& place) {
    QPainterPath path;
    path.addRoundedRect(place, 1.5, 1.5);
    return path;
}

QPainterPath lines(std::initializer_list<QLineF> all) {
    QPainterPath path;
    for (const QLineF& line : all) {
        path.moveTo(line.p1());
        path.lineTo(line.p2());
    }
    return path;
}

QPainterPath new_layer() {
    QPainterPath path = sheet({2.0, 2.0, 12.0, 12.0});
    path.addPath(lines({{8.0, 5.2, 8.0, 10.8}, {5.2, 8.0, 10.8, 8.0}}));
    return path;
}

QPainterPath two_sheets() {
    QPainterPath path = sheet({2.0, 2.0, 8.5, 8.5});
    path.addPath(lines({{13.9, 5.5, 13.9, 13.9}, {13.9, 13.9, 5.5, 13.9}}));
    path.addPath(lines({{10.5, 5.5, 13.9, 5.5}, {5.5, 10.5, 5.5, 13.9}}));
    return path;
}

QPainterPath arrow_onto_line() {
    return lines(
        {{8.0, 1.8, 8.0, 10.0}, {8.0, 10.0, 4.8, 6.8}, {8.0, 10.0, 11.2, 6.8}, {2.0, 13.8, 14.0, 13.8}});
}

QPainterPath folder() {
    QPainterPath path(QPointF(1.8, 13.2));
    path.lineTo(1.8, 3.2);
    path.lineTo(6.2, 3.2);
    path.lineTo(7.8, 5.2);
    path.lineTo(14.2, 5.2);
    path.lineTo(14.2, 13.2);
    path.closeSubpath();
    return path;
}

QPainterPath bin() {
    QPainterPath path = lines({{2.2, 4.2, 13.8, 4.2}, {6.0, 4.2, 6.0, 2.0}, {6.0, 2.0, 10.0, 2.0}});
    path.addPath(lines({{10.0, 2.0, 10.0, 4.2}, {6.6, 7.0, 6.6, 11.4}, {9.4, 7.0, 9.4, 11.4}}));
    path.moveTo(3.8, 4.2);
    path.lineTo(4.4, 14.2);
    path.lineTo(11.6, 14.2);
    path.lineTo(12.2, 4.2);
    return path;
}

QPainterPath outline_of(LayerIcon icon) {
    switch (icon) {
        case LayerIcon::Eye:
            return eye_outline();
        case LayerIcon::ClosedEye:
            return closed_eye();
        case LayerIcon::Lock:
            return shackle(false);
        case LayerIcon::OpenLock:
            return shackle(true);
        case LayerIcon::New:
            return new_layer();
        case LayerIcon::Duplicate:
            return two_sheets();
        case LayerIcon::MergeDown:
            return arrow_onto_line();
        case LayerIcon::Group:
            return folder();
        case LayerIcon::Remove:
            return bin();
        case LayerIcon::Folded:
            return lines({{6.2, 4.4, 9.8, 8.0}, {9.8, 8.0, 6.2, 11.6}});
        case LayerIcon::Unfolded:
            return lines({{4.4, 6.2, 8.0, 9.8}, {8.0, 9.8, 11.6, 6.2}});
    }
    return {};
}

QPainterPath filled_part_of(LayerIcon icon) {
    QPainterPath path;
    if (icon == LayerIcon::Eye) path.addEllipse(QPointF(8.0, 8.0), 2.4, 2.4);
    if (icon == LayerIcon::Lock || icon == LayerIcon::OpenLock) path = lock_body();
    return path;
}

QPixmap icon_picture(LayerIcon icon, double pixel_ratio, const QColor& colour) {
    QPixmap pixmap(QSize(kSide, kSide) * pixel_ratio);
    pixmap.setDevicePixelRatio(pixel_ratio);
    pixmap.fill(Qt::transparent);
    QPainter painter(&pixmap);
    draw_icon(painter, QRectF(0, 0, kSide, kSide), icon, colour);
    return pixmap;
}

}  // namespace

void draw_icon(QPainter& painter, const QRectF& place, LayerIcon icon, const QColor& colour) {
    painter.save();
    painter.setRenderHint(QPainter::Antialiasing);
    painter.translate(place.center() - QPointF(0.5 * kSide, 0.5 * kSide));
    painter.strokePath(outline_of(icon),
                       QPen(colour, kLine, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
    painter.fillPath(filled_part_of(icon), colour);
    painter.restore();
}

QIcon layer_icon(LayerIcon icon, double pixel_ratio) {
    const QPalette palette = QApplication::palette();
    QIcon result;
    result.addPixmap(icon_picture(icon, pixel_ratio, palette.color(QPalette::ButtonText)),
                     QIcon::Normal);
    result.addPixmap(
        icon_picture(icon, pixel_ratio, palette.color(QPalette::Disabled, QPalette::ButtonText)),
        QIcon::Disabled);
    return result;
}

}  // namespace pastoso::panels
