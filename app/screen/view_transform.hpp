// Where the canvas lies on the screen. Device pixels are the screen's own, whatever the desktop's scale
// factor; both axes run right and down, pixel centres lie at halves.
#pragma once

#include <array>
#include <optional>

#include <glm/mat2x2.hpp>
#include <glm/vec2.hpp>

namespace pastoso::screen {

inline constexpr double kSmallestZoom = 1.0 / 64.0;
inline constexpr double kLargestZoom = 64.0;

/// device = origin_px + zoom axes() cell. `zoom` is device pixels per cell: 1 shows the picture as it is
/// saved.
struct ViewTransform {
    glm::dvec2 origin_px{0.0,
                         0.0};  ///< the corner of the canvas that is the upper left one of its picture
    double zoom = 1.0;
    double angle_deg = 0.0;  ///< clockwise on the screen, above -180 to 180
    bool mirrored = false;   ///< left and right change places before the canvas is turned

    /// Where the canvas's two axes run on the screen: of unit length, and at right angles. Exact at
    /// quarter turns: of 0, 1 and -1 alone.
    glm::dmat2 axes() const;

    glm::dvec2 device_from_cell(const glm::dvec2& cell) const {
        return origin_px + zoom * (axes() * cell);
    }
    glm::dvec2 cell_from_device(const glm::dvec2& device_px) const;

    /// Whether the canvas's axes run along the screen's.
    bool upright() const;
    friend bool operator==(const ViewTransform&, const ViewTransform&) = default;
};

/// Where a point of the window as it is seen from one place lies as it is seen from another.
glm::dvec2 moved_px(const ViewTransform& from, const ViewTransform& to, const glm::dvec2& px);

/// How far the picture has moved from one place to the other; none when it is not by whole pixels alone.
std::optional<glm::ivec2> whole_pixels_between(const ViewTransform& from, const ViewTransform& to);

/// Multiplies the zoom (within its limits) so that the point of the canvas under `anchor_px` stays
/// there.
ViewTransform zoomed(const ViewTransform& view, const glm::dvec2& anchor_px, double factor);

/// Turned clockwise about the point of the canvas under `anchor_px`. A canvas that stands upright then
/// comes to lie on whole pixels, half a pixel beside where it would.
ViewTransform turned(const ViewTransform& view, const glm::dvec2& anchor_px, double by_deg);

/// Left and right of the window change places.
ViewTransform mirrored(const ViewTransform& view, const glm::dvec2& window_px);

/// Shifted by a drag in device pixels, never so far that less than `keep_px` of the canvas stays in the
/// window.
ViewTransform panned(const ViewTransform& view, const glm::dvec2& drag_px,
                     const glm::dvec2& canvas_cells, const glm::dvec2& window_px, double keep_px = 48.0);

/// The points of the canvas below two fingers stay below them, `turns` or not; fingers on one place do
/// nothing.
using Fingers = std::array<glm::dvec2, 2>;
ViewTransform pinched(const ViewTransform& view, const Fingers& from_px, const Fingers& to_px,
                      bool turns = true);

/// The whole canvas, centred, with a margin, turned and mirrored as `view` is.
ViewTransform fitted(const glm::dvec2& canvas_cells, const glm::dvec2& window_px,
                     double margin_px = 24.0, const ViewTransform& view = {});

/// Moves the origin to whole device pixels, so that at zoom 1 cells and pixels coincide.
ViewTransform snapped(const ViewTransform& view);

/// The smallest upright rectangle that holds the picture of a rectangle of cells, in device pixels.
struct DeviceBox {
    glm::dvec2 low{}, high{};
};
DeviceBox device_box(const ViewTransform& view, const glm::dvec2& low_cell, const glm::dvec2& high_cell);

}  // namespace pastoso::screen
