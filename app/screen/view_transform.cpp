#include "screen/view_transform.hpp"

#include "core/units.hpp"

#include <algorithm>
#include <cmath>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

namespace pastoso::screen {
namespace {

constexpr double kQuarter_deg = 90.0;

/// Clockwise on the screen; exact at quarter turns.
glm::dmat2 rotation(double angle_deg) {
    const double quarters = std::round(angle_deg / kQuarter_deg);
    const double rest = core::radians(angle_deg - kQuarter_deg * quarters);
    glm::dvec2 across{std::cos(rest), std::sin(rest)};
    for (int i = (static_cast<int>(quarters) % 4 + 4) % 4; i > 0; --i)
        across = {-across.y, across.x};
    return {across, {-across.y, across.x}};
}

double within_a_turn(double angle_deg) {
    const double angle = std::remainder(angle_deg, 360.0);
    return angle == -180.0 ? 180.0 : angle;
}

/// The view with this cell at that pixel.
ViewTransform put_at(ViewTransform view, const glm::dvec2& cell, const glm::dvec2& device_px) {
    view.origin_px = device_px - view.zoom * (view.axes() * cell);
    return view;
}

double allowed_zoom(double zoom) {
    return std::clamp(zoom, kSmallestZoom, kLargestZoom);
}

}  // namespace

glm::dmat2 ViewTransform::axes() const {
    glm::dmat2 axes = rotation(angle_deg);
    if (mirrored) axes[0] = -axes[0];
    return axes;
}

glm::dvec2 ViewTransform::cell_from_device(const glm::dvec2& device_px) const {
    return glm::transpose(axes()) * (device_px - origin_px) / zoom;
}

bool ViewTransform::upright() const {
    return std::remainder(angle_deg, kQuarter_deg) == 0.0;
}

glm::dvec2 moved_px(const ViewTransform& from, const ViewTransform& to, const glm::dvec2& px) {
    return to.device_from_cell(from.cell_from_device(px));
}

std::optional<glm::ivec2> whole_pixels_between(const ViewTransform& from, const ViewTransform& to) {
    const glm::dvec2 by_px = to.origin_px - from.origin_px;
    const bool pans = to.zoom == from.zoom && to.angle_deg == from.angle_deg &&
                      to.mirrored == from.mirrored && by_px == glm::round(by_px);
    return pans ? std::optional(glm::ivec2(by_px)) : std::nullopt;
}

ViewTransform zoomed(const ViewTransform& view, const glm::dvec2& anchor_px, double factor) {
    ViewTransform next = view;
    next.zoom = allowed_zoom(view.zoom * factor);
    return next == view ? view : put_at(next, view.cell_from_device(anchor_px), anchor_px);
}

ViewTransform turned(const ViewTransform& view, const glm::dvec2& anchor_px, double by_deg) {
    ViewTransform next = view;
    next.angle_deg = within_a_turn(view.angle_deg + by_deg);
    next = put_at(next, view.cell_from_device(anchor_px), anchor_px);
    return next.upright() ? snapped(next) : next;
}

ViewTransform mirrored(const ViewTransform& view, const glm::dvec2& window_px) {
    ViewTransform next = view;
    next.origin_px.x = window_px.x - view.origin_px.x;
    next.angle_deg = within_a_turn(-view.angle_deg);
    next.mirrored = !view.mirrored;
    return next;
}

ViewTransform panned(const ViewTransform& view, const glm::dvec2& drag_px,
                     const glm::dvec2& canvas_cells, const glm::dvec2& window_px, double keep_px) {
    const DeviceBox box = device_box(view, {0.0, 0.0}, canvas_cells);
    const glm::dvec2 lowest = keep_px - (box.high - view.origin_px);
    const glm::dvec2 highest = window_px - keep_px - (box.low - view.origin_px);
    ViewTransform next = view;
    next.origin_px = glm::clamp(view.origin_px + drag_px, lowest, glm::max(lowest, highest));
    return next;
}

ViewTransform pinched(const ViewTransform& view, const Fingers& from_px, const Fingers& to_px,
                      bool turns) {
    const glm::dvec2 from = from_px[1] - from_px[0], to = to_px[1] - to_px[0];
    if (from == glm::dvec2(0.0) || to == glm::dvec2(0.0)) return view;
    ViewTransform next = view;
    next.zoom = allowed_zoom(view.zoom * glm::length(to) / glm::length(from));
    const double turn = std::atan2(to.y, to.x) - std::atan2(from.y, from.x);
    if (turns) next.angle_deg = within_a_turn(view.angle_deg + core::degrees(turn));
    return put_at(next, view.cell_from_device(0.5 * (from_px[0] + from_px[1])),
                  0.5 * (to_px[0] + to_px[1]));
}

ViewTransform fitted(const glm::dvec2& canvas_cells, const glm::dvec2& window_px, double margin_px,
                     const ViewTransform& view) {
    const glm::dvec2 room = glm::max(window_px - 2.0 * margin_px, glm::dvec2(1.0));
    ViewTransform next = view;
    next.zoom = 1.0;
    const DeviceBox box = device_box(next, {0.0, 0.0}, canvas_cells);
    const glm::dvec2 zooms = room / (box.high - box.low);
    next.zoom = allowed_zoom(std::min(zooms.x, zooms.y));
    return snapped(put_at(next, 0.5 * canvas_cells, 0.5 * window_px));
}

ViewTransform snapped(const ViewTransform& view) {
    ViewTransform next = view;
    next.origin_px = glm::round(view.origin_px);
    return next;
}

DeviceBox device_box(const ViewTransform& view, const glm::dvec2& low_cell,
                     const glm::dvec2& high_cell) {
    DeviceBox box;
    box.low = box.high = view.device_from_cell(low_cell);
    for (const glm::dvec2& cell : {high_cell, {low_cell.x, high_cell.y}, {high_cell.x, low_cell.y}}) {
        const glm::dvec2 px = view.device_from_cell(cell);
        box.low = glm::min(box.low, px);
        box.high = glm::max(box.high, px);
    }
    return box;
}

}  // namespace pastoso::screen
