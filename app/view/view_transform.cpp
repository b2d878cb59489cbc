#include "view/view_transform.hpp"

#include <algorithm>

#include <glm/common.hpp>

namespace pastoso::view {

ViewTransform zoomed(const ViewTransform& view, const glm::dvec2& anchor_px, double factor) {
    const double zoom = std::clamp(view.zoom * factor, kSmallestZoom, kLargestZoom);
    const glm::dvec2 cell = view.cell_from_device(anchor_px);
    return {anchor_px - zoom * cell, zoom};
}

ViewTransform panned(const ViewTransform& view, const glm::dvec2& drag_px,
                     const glm::dvec2& canvas_cells, const glm::dvec2& window_px, double keep_px) {
    const glm::dvec2 lowest = keep_px - view.zoom * canvas_cells;
    const glm::dvec2 highest = window_px - keep_px;
    return {glm::clamp(view.origin_px + drag_px, lowest, glm::max(lowest, highest)), view.zoom};
}

ViewTransform fitted(const glm::dvec2& canvas_cells, const glm::dvec2& window_px, double margin_px) {
    const glm::dvec2 room = glm::max(window_px - 2.0 * margin_px, glm::dvec2(1.0));
    const glm::dvec2 zooms = room / canvas_cells;
    const double zoom = std::clamp(std::min(zooms.x, zooms.y), kSmallestZoom, kLargestZoom);
    return snapped({0.5 * (window_px - zoom * canvas_cells), zoom});
}

ViewTransform snapped(const ViewTransform& view) {
    return {glm::round(view.origin_px), view.zoom};
}

}  // namespace pastoso::view
