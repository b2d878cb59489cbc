#include "screen/canvas_sheet.hpp"

#include <cmath>

#include <glm/common.hpp>
#include <glm/matrix.hpp>

namespace pastoso::screen {

CanvasSheet::CanvasSheet(const grid::Shape& canvas, const ViewTransform& view) {
    const glm::dmat2 axes = view.axes();
    const glm::dvec2 along_axes = glm::transpose(axes) * view.origin_px;
    // Of the canvas's corner from the sheet's.
    const glm::dvec2 shift_px = along_axes - glm::floor(along_axes);
    lattice = {-shift_px.x / view.zoom,
               -shift_px.y / view.zoom,
               view.zoom,
               view.zoom,
               static_cast<int>(std::ceil(canvas.width * view.zoom + shift_px.x)),
               static_cast<int>(std::ceil(canvas.height * view.zoom + shift_px.y))};
    const glm::dvec2 corner = axes * glm::floor(along_axes);
    to_window = {axes[0].x, axes[0].y, axes[1].x, axes[1].y, corner.x, corner.y};
}

grid::Rect CanvasSheet::pixels_below(const QRect& window) const {
    const QRectF part = to_window.inverted().mapRect(QRectF(window));
    const grid::Rect pixels{
        static_cast<int>(std::floor(part.left())) - 1, static_cast<int>(std::floor(part.top())) - 1,
        static_cast<int>(std::ceil(part.right())) + 1, static_cast<int>(std::ceil(part.bottom())) + 1};
    return grid::intersection(pixels, {0, 0, lattice.width, lattice.height});
}

}  // namespace pastoso::screen
