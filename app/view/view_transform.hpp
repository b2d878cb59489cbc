// Where the canvas lies on the screen. Device pixels are the screen's own, whatever the desktop's scale
// factor; both axes run right and down, pixel centres lie at halves.
#pragma once

#include <glm/vec2.hpp>

namespace pastoso::view {

inline constexpr double kSmallestZoom = 1.0 / 64.0;
inline constexpr double kLargestZoom = 64.0;

/// device = origin_px + zoom * cell. `zoom` is device pixels per cell: 1 shows the picture as it is
/// saved.
struct ViewTransform {
    glm::dvec2 origin_px{0.0, 0.0};  ///< the upper left corner of the canvas
    double zoom = 1.0;

    glm::dvec2 device_from_cell(const glm::dvec2& cell) const { return origin_px + zoom * cell; }
    glm::dvec2 cell_from_device(const glm::dvec2& device_px) const {
        return (device_px - origin_px) / zoom;
    }
    friend bool operator==(const ViewTransform&, const ViewTransform&) = default;
};

/// Multiplies the zoom (within its limits) so that the point of the canvas under `anchor_px` stays
/// there.
ViewTransform zoomed(const ViewTransform& view, const glm::dvec2& anchor_px, double factor);

/// Shifted by a drag in device pixels, never so far that less than `keep_px` of the canvas stays in the
/// window.
ViewTransform panned(const ViewTransform& view, const glm::dvec2& drag_px,
                     const glm::dvec2& canvas_cells, const glm::dvec2& window_px, double keep_px = 48.0);

/// The whole canvas, centred, with a margin.
ViewTransform fitted(const glm::dvec2& canvas_cells, const glm::dvec2& window_px,
                     double margin_px = 24.0);

/// Moves the origin to whole device pixels, so that at zoom 1 cells and pixels coincide.
ViewTransform snapped(const ViewTransform& view);

}  // namespace pastoso::view
