#include "panels/paint/drawdown_picture.hpp"

#include "appearance/screen_colours.hpp"
#include "panels/paint/swatch_colours.hpp"

#include <QPainter>
#include <QPolygonF>

namespace pastoso::panels {

void draw_drawdown(QPainter& painter, const QRectF& place, const tools::Drawdown& drawdown) {
    constexpr int kSteps = tools::Drawdown::kSteps;
    painter.save();
    painter.setRenderHint(QPainter::Antialiasing, false);
    const double half = place.height() / 2.0;
    for (int step = 0; step < kSteps; ++step) {
        const double left = place.left() + place.width() * step / kSteps;
        const double right = place.left() + place.width() * (step + 1) / kSteps;
        const auto fill = [&](double top, const pigment::Srgb8& colour) {
            painter.fillRect(QRectF(left, top, right - left, half), appearance::shown(qcolor(colour)));
        };
        fill(place.top(), drawdown.over_white[static_cast<std::size_t>(step)]);
        fill(place.top() + half, drawdown.over_black[static_cast<std::size_t>(step)]);
    }
    painter.restore();
}

void draw_hiding_mark(QPainter& painter, const QRectF& place, pigment::Hiding hiding,
                      const QColor& ink) {
    using pigment::Hiding;
    painter.save();
    painter.setPen(QPen(ink, 1.0));
    if (hiding == Hiding::Opaque) painter.fillRect(place, ink);
    if (hiding == Hiding::SemiTransparent) painter.drawLine(place.bottomLeft(), place.topRight());
    if (hiding == Hiding::SemiOpaque) {
        painter.setBrush(ink);
        painter.drawPolygon(QPolygonF({place.bottomLeft(), place.topRight(), place.bottomRight()}));
        painter.setBrush(Qt::NoBrush);
    }
    painter.drawRect(place);
    painter.restore();
}

}  // namespace pastoso::panels
