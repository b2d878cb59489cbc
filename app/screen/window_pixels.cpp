#include "screen/window_pixels.hpp"

#include "appearance/theme.hpp"

#include <cmath>

#include <glm/common.hpp>

namespace pastoso::screen {

QSize window_px(const QWidget& widget) {
    const double ratio = widget.devicePixelRatioF();
    return {static_cast<int>(std::round(widget.width() * ratio)),
            static_cast<int>(std::round(widget.height() * ratio))};
}

grid::Rect seen_cells(const ViewTransform& view, const QSize& window_px, const grid::Shape& canvas) {
    const glm::dvec2 cells{canvas.width, canvas.height};
    const glm::dvec2 window{window_px.width(), window_px.height()};
    glm::dvec2 first = cells, last{0.0, 0.0};
    for (const glm::dvec2& px : {{0.0, 0.0}, window, {window.x, 0.0}, {0.0, window.y}}) {
        const glm::dvec2 cell = view.cell_from_device(px);
        first = glm::min(first, glm::max(glm::floor(cell), 0.0));
        last = glm::max(last, glm::min(glm::ceil(cell), cells));
    }
    return {static_cast<int>(first.x), static_cast<int>(first.y), static_cast<int>(last.x),
            static_cast<int>(last.y)};
}

Rgb ground_colour() {
    const QColor& ground = appearance::colours().ground;
    return {static_cast<float>(ground.redF()), static_cast<float>(ground.greenF()),
            static_cast<float>(ground.blueF())};
}

}  // namespace pastoso::screen
