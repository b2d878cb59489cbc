#include "screen/damaged_pixels.hpp"

#include "screen/canvas_layers.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include <glm/common.hpp>

namespace pastoso::screen {
namespace {

constexpr int kStrip_px = 32;

using Corners = std::array<glm::dvec2, 4>;

QRect pixels_between(const glm::dvec2& low, const glm::dvec2& high) {
    const glm::dvec2 first = glm::floor(low) - 1.0, last = glm::ceil(high) + 1.0;
    return {QPoint(static_cast<int>(first.x), static_cast<int>(first.y)),
            QPoint(static_cast<int>(last.x), static_cast<int>(last.y))};
}

/// From where to where the shape reaches between two heights, which it touches.
glm::dvec2 reach_between(const Corners& corners, double top, double bottom) {
    glm::dvec2 reach{1e300, -1e300};
    const auto add = [&](double x) { reach = {std::min(reach.x, x), std::max(reach.y, x)}; };
    for (std::size_t i = 0; i < corners.size(); ++i) {
        const glm::dvec2 a = corners[i], b = corners[(i + 1) % corners.size()];
        if (a.y >= top && a.y <= bottom) add(a.x);
        for (const double y : {top, bottom})
            if ((a.y - y) * (b.y - y) < 0.0) add(a.x + (b.x - a.x) * (y - a.y) / (b.y - a.y));
    }
    return reach;
}

}  // namespace

QRegion damaged_pixels(const ViewTransform& view, const QRect& cells) {
    const glm::dvec2 low{cells.x() - kLayerBorder, cells.y() - kLayerBorder};
    const glm::dvec2 high =
        low + glm::dvec2{cells.width() + 2 * kLayerBorder, cells.height() + 2 * kLayerBorder};
    const DeviceBox box = device_box(view, low, high);
    if (view.upright()) return pixels_between(box.low, box.high);
    const Corners corners{view.device_from_cell(low), view.device_from_cell({high.x, low.y}),
                          view.device_from_cell(high), view.device_from_cell({low.x, high.y})};
    QRegion region;
    for (double top = box.low.y; top < box.high.y; top += kStrip_px) {
        const double bottom = std::min(top + kStrip_px, box.high.y);
        const glm::dvec2 reach = reach_between(corners, top, bottom);
        region += pixels_between({reach.x, top}, {reach.y, bottom});
    }
    return region;
}

QRegion damaged_pixels(const ViewTransform& view, const QRegion& cells) {
    QRegion region;
    for (const QRect& part : cells)
        region += damaged_pixels(view, part);
    return region;
}

}  // namespace pastoso::screen
