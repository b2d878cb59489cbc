#include "appearance/cursors.hpp"

#include "core/units.hpp"

#include <cmath>

#include <QPainter>
#include <QPainterPath>
#include <QPixmap>

namespace pastoso::appearance {

Qt::CursorShape scaling_cursor(const QPointF& way) {
    static constexpr Qt::CursorShape kShapes[] = {Qt::SizeHorCursor, Qt::SizeFDiagCursor,
                                                  Qt::SizeVerCursor, Qt::SizeBDiagCursor};
    const double eighths = std::atan2(way.y(), way.x()) / (0.25 * core::kPi);
    return kShapes[(static_cast<int>(std::lround(eighths)) + 8) % 4];
}

const QCursor& turning_cursor() {
    static const QCursor cursor = [] {
        constexpr int kSide = 24;
        QPixmap picture(kSide, kSide);
        picture.fill(Qt::transparent);
        QPainter painter(&picture);
        painter.setRenderHint(QPainter::Antialiasing);
        QPainterPath bow;
        bow.arcMoveTo(5, 6, 14, 14, 30);
        bow.arcTo(5, 6, 14, 14, 30, 120);
        QPainterPath points;
        points.addPolygon(QPolygonF({{19.5, 5.5}, {19.5, 12.0}, {13.5, 10.0}}));
        points.closeSubpath();
        points.addPolygon(QPolygonF({{4.5, 5.5}, {4.5, 12.0}, {10.5, 10.0}}));
        points.closeSubpath();
        painter.strokePath(bow, QPen(Qt::white, 4.0, Qt::SolidLine, Qt::FlatCap));
        painter.strokePath(points, QPen(Qt::white, 2.0));
        painter.strokePath(bow, QPen(Qt::black, 2.0, Qt::SolidLine, Qt::FlatCap));
        painter.fillPath(points, Qt::black);
        painter.end();
        return QCursor(picture, kSide / 2, kSide / 2);
    }();
    return cursor;
}

}  // namespace pastoso::appearance
