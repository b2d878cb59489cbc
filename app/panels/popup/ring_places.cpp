#include "panels/popup/ring_places.hpp"

#include "core/units.hpp"

#include <algorithm>
#include <cmath>

#include <QSize>

namespace pastoso::panels {

std::vector<QPointF> ring_places(int count, double radius, double from_deg, double to_deg) {
    const bool closed = to_deg - from_deg >= 360.0;
    const int steps = std::max(closed ? count : count - 1, 1);
    std::vector<QPointF> places;
    for (int i = 0; i < count; ++i) {
        const double angle = core::radians(from_deg + (to_deg - from_deg) * i / steps);
        places.emplace_back(radius * std::cos(angle), radius * std::sin(angle));
    }
    return places;
}

QPoint corner_on_screen(const QPoint& middle, const QSize& size, const QRect& screen) {
    const auto kept = [](int wanted, int least, int most) {
        return std::max(std::min(wanted, most), least);
    };
    return {kept(middle.x() - size.width() / 2, screen.left(), screen.right() + 1 - size.width()),
            kept(middle.y() - size.height() / 2, screen.top(), screen.bottom() + 1 - size.height())};
}

}  // namespace pastoso::panels
