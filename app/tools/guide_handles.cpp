#include "tools/guide_handles.hpp"

#include "core/units.hpp"
#include "tools/laid_guide.hpp"

#include <algorithm>
#include <cmath>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

namespace pastoso::tools {
namespace {

constexpr double kAngleStep_deg = 15.0;

using Form = decltype(brush::PenGuide::form);

/// Shorter guides have no direction worth following.
constexpr double kLeastLength_mm = 1.0;

glm::dvec2 direction(double angle_deg) {
    return {std::cos(core::radians(angle_deg)), std::sin(core::radians(angle_deg))};
}

double angle_deg(const glm::dvec2& from, const glm::dvec2& to, bool square) {
    const glm::dvec2 way = to - from;
    const double angle = core::degrees(std::atan2(way.y, way.x));
    return square ? kAngleStep_deg * std::round(angle / kAngleStep_deg) : angle;
}

glm::dvec2 centre(const brush::Symmetry& symmetry) {
    return {symmetry.centre_x_mm, symmetry.centre_y_mm};
}
glm::dvec2 centre(const brush::EllipseCurve& ellipse) {
    return {ellipse.centre_x_mm, ellipse.centre_y_mm};
}
glm::dvec2 start(const brush::Ruler& ruler) {
    return {ruler.x1_mm, ruler.y1_mm};
}
glm::dvec2 end(const brush::Ruler& ruler) {
    return {ruler.x2_mm, ruler.y2_mm};
}
brush::Ruler ruler_between(const glm::dvec2& from, const glm::dvec2& to) {
    return {from.x, from.y, to.x, to.y};
}

/// `moving` at a place, or on the nearest step of the angle about the `fixed` end.
glm::dvec2 swung(const glm::dvec2& fixed, const glm::dvec2& moving, bool square) {
    const double length_mm = std::max(glm::distance(fixed, moving), kLeastLength_mm);
    return fixed + length_mm * direction(angle_deg(fixed, moving, square));
}

brush::Symmetry dragged_symmetry(brush::Symmetry symmetry, Handle handle, const glm::dvec2& place_mm,
                                 bool square) {
    if (handle == Handle::MirrorAxis) {
        symmetry.axis_deg = angle_deg(centre(symmetry), place_mm, square);
        return symmetry;
    }
    symmetry.centre_x_mm = place_mm.x;
    symmetry.centre_y_mm = place_mm.y;
    return symmetry;
}

brush::Ruler dragged_ruler(const brush::Ruler& ruler, Handle handle, const glm::dvec2& place_mm,
                           bool square) {
    if (handle == Handle::RulerStart)
        return ruler_between(swung(end(ruler), place_mm, square), end(ruler));
    if (handle == Handle::RulerEnd)
        return ruler_between(start(ruler), swung(start(ruler), place_mm, square));
    const glm::dvec2 shift = place_mm - 0.5 * (start(ruler) + end(ruler));
    return ruler_between(start(ruler) + shift, end(ruler) + shift);
}

brush::EllipseCurve dragged_ellipse(brush::EllipseCurve ellipse, Handle handle,
                                    const glm::dvec2& place_mm, bool square) {
    if (handle == Handle::EllipseCentre) {
        ellipse.centre_x_mm = place_mm.x;
        ellipse.centre_y_mm = place_mm.y;
        return ellipse;
    }
    const double length_mm = std::max(glm::distance(centre(ellipse), place_mm), kLeastLength_mm);
    const bool width = handle == Handle::EllipseWidth;
    double& dragged_mm = width ? ellipse.half_width_mm : ellipse.half_height_mm;
    double& other_mm = width ? ellipse.half_height_mm : ellipse.half_width_mm;
    if (square) other_mm = std::max(other_mm * length_mm / dragged_mm, kLeastLength_mm);
    dragged_mm = length_mm;
    if (width) ellipse.turn_deg = angle_deg(centre(ellipse), place_mm, square);
    return ellipse;
}

/// Where a vanishing point's members are.
struct PointMembers {
    double brush::VanishingPoints::*x_mm;
    double brush::VanishingPoints::*y_mm;
};
constexpr PointMembers kPoints[] = {{&brush::VanishingPoints::x1_mm, &brush::VanishingPoints::y1_mm},
                                    {&brush::VanishingPoints::x2_mm, &brush::VanishingPoints::y2_mm},
                                    {&brush::VanishingPoints::x3_mm, &brush::VanishingPoints::y3_mm}};
constexpr Handle kPointHandles[] = {Handle::FirstPoint, Handle::SecondPoint, Handle::ThirdPoint};

glm::dvec2 first_point(const brush::VanishingPoints& points) {
    return {points.x1_mm, points.y1_mm};
}

brush::VanishingPoints dragged_points(brush::VanishingPoints points, Handle handle,
                                      const glm::dvec2& place_mm, bool square) {
    if (handle == Handle::Horizon) {
        points.level_deg = std::remainder(angle_deg(first_point(points), place_mm, square), 180.0);
        points.upright_deg = points.level_deg + 90.0;
        return points;
    }
    for (int i = 0; i < points.count; ++i) {
        if (handle != kPointHandles[i]) continue;
        points.*kPoints[i].x_mm = place_mm.x;
        points.*kPoints[i].y_mm = place_mm.y;
    }
    return with_horizon(points);
}

glm::dvec2 centre(const brush::Grid& grid) {
    return {grid.x_mm, grid.y_mm};
}

/// How much longer the way along one family from line to line is than at right angles to them.
double slant(const brush::Grid& grid) {
    constexpr double kLeastSine = 0.05;
    const double between = core::radians(grid.other_direction_deg - grid.direction_deg);
    return 1.0 / std::max(std::abs(std::sin(between)), kLeastSine);
}

brush::Grid dragged_grid(brush::Grid grid, Handle handle, const glm::dvec2& place_mm, bool square) {
    if (handle == Handle::GridMiddle) {
        grid.x_mm = place_mm.x;
        grid.y_mm = place_mm.y;
        return grid;
    }
    const double length_mm = std::max(glm::distance(centre(grid), place_mm), kLeastLength_mm);
    const double to_deg = angle_deg(centre(grid), place_mm, square);
    if (handle == Handle::GridAlong) {
        grid.other_direction_deg =
            std::remainder(grid.other_direction_deg + to_deg - grid.direction_deg, 360.0);
        grid.direction_deg = to_deg;
        grid.other_spacing_mm = std::max(length_mm / slant(grid), kLeastLength_mm);
        return grid;
    }
    grid.other_direction_deg = to_deg;
    grid.spacing_mm = std::max(length_mm / slant(grid), kLeastLength_mm);
    return grid;
}

/// Puts up the handles of what is laid.
struct HandlePlacer {
    const glm::dvec2& canvas_mm;
    std::vector<PlacedHandle>& handles;

    void add(Handle handle, const glm::dvec2& place_mm) const {
        handles.push_back({handle, place_mm, place_mm});
    }
    bool is_on_canvas(const glm::dvec2& point_mm) const {
        return point_mm == glm::clamp(point_mm, glm::dvec2(0.0), canvas_mm);
    }
    void add_within_canvas(Handle handle, const glm::dvec2& point_mm) const {
        constexpr double kMargin = 0.03;
        const glm::dvec2 margin_mm(kMargin * std::min(canvas_mm.x, canvas_mm.y));
        const glm::dvec2 place_mm =
            is_on_canvas(point_mm) ? point_mm : glm::clamp(point_mm, margin_mm, canvas_mm - margin_mm);
        handles.push_back({handle, place_mm, point_mm});
    }
    double axis_mm() const {
        constexpr double kShare = 0.4;
        return kShare * std::min(canvas_mm.x, canvas_mm.y);
    }

    void operator()(const brush::Symmetry& symmetry) const {
        if (symmetry.mirror || symmetry.count > 1) add(Handle::SymmetryCentre, centre(symmetry));
        if (symmetry.mirror)
            add(Handle::MirrorAxis, centre(symmetry) + axis_mm() * direction(symmetry.axis_deg));
    }
    void operator()(const brush::Ruler& ruler) const {
        add(Handle::RulerStart, start(ruler));
        add(Handle::RulerEnd, end(ruler));
        add(Handle::RulerMiddle, 0.5 * (start(ruler) + end(ruler)));
    }
    void operator()(const brush::EllipseCurve& ellipse) const {
        const glm::dvec2 along = direction(ellipse.turn_deg),
                         across = direction(ellipse.turn_deg + 90.0);
        add(Handle::EllipseCentre, centre(ellipse));
        add(Handle::EllipseWidth, centre(ellipse) + ellipse.half_width_mm * along);
        add(Handle::EllipseHeight, centre(ellipse) + ellipse.half_height_mm * across);
    }
    void operator()(const brush::VanishingPoints& points) const {
        for (int i = 0; i < points.count; ++i)
            add_within_canvas(kPointHandles[i], {points.*kPoints[i].x_mm, points.*kPoints[i].y_mm});
        if (points.count > 1 || !is_on_canvas(first_point(points))) return;
        const glm::dvec2 level = direction(points.level_deg);
        const bool ahead = glm::dot(0.5 * canvas_mm - first_point(points), level) >= 0.0;
        add(Handle::Horizon, first_point(points) + (ahead ? axis_mm() : -axis_mm()) * level);
    }
    void operator()(const brush::Grid& grid) const {
        add(Handle::GridMiddle, centre(grid));
        add(Handle::GridAlong,
            centre(grid) + slant(grid) * grid.other_spacing_mm * direction(grid.direction_deg));
        add(Handle::GridAcross,
            centre(grid) + slant(grid) * grid.spacing_mm * direction(grid.other_direction_deg));
    }
    void operator()(std::monostate) const {}
    void operator()(const brush::StraightLine&) const {}
};

/// What is laid after its handle was dragged.
struct Dragged {
    Handle handle;
    const glm::dvec2& place_mm;
    bool square;

    Form operator()(const brush::Ruler& ruler) const {
        return dragged_ruler(ruler, handle, place_mm, square);
    }
    Form operator()(const brush::EllipseCurve& ellipse) const {
        return dragged_ellipse(ellipse, handle, place_mm, square);
    }
    Form operator()(const brush::VanishingPoints& points) const {
        return dragged_points(points, handle, place_mm, square);
    }
    Form operator()(const brush::Grid& grid) const {
        return dragged_grid(grid, handle, place_mm, square);
    }
    Form operator()(const auto& other) const { return other; }
};

}  // namespace

std::vector<PlacedHandle> guide_handles(const Hand& hand, const glm::dvec2& canvas_mm) {
    std::vector<PlacedHandle> handles;
    const HandlePlacer placer{canvas_mm, handles};
    placer(hand.symmetry);
    std::visit(placer, hand.laid.form);
    return handles;
}

std::optional<PlacedHandle> handle_at(const std::vector<PlacedHandle>& handles,
                                      const glm::dvec2& place_mm, double reach_mm) {
    std::optional<PlacedHandle> nearest;
    for (const PlacedHandle& handle : handles) {
        const double away_mm = glm::distance(handle.place_mm, place_mm);
        if (away_mm > reach_mm) continue;
        reach_mm = away_mm;
        nearest = handle;
    }
    return nearest;
}

Guide dragged(const Hand& hand, Handle handle, const glm::dvec2& place_mm, bool square) {
    if (handle == Handle::SymmetryCentre || handle == Handle::MirrorAxis)
        return dragged_symmetry(hand.symmetry, handle, place_mm, square);
    brush::PenGuide guide = hand.laid;
    guide.form = std::visit(Dragged{handle, place_mm, square}, hand.laid.form);
    return guide;
}

}  // namespace pastoso::tools
