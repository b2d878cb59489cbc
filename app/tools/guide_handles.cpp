#include "tools/guide_handles.hpp"

#include "core/check.hpp"
#include "core/units.hpp"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

namespace pastoso::tools {
namespace {

constexpr double kAngleStep_deg = 15.0;

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

}  // namespace

std::vector<PlacedHandle> guide_handles(const Hand& hand, double axis_mm) {
    std::vector<PlacedHandle> handles;
    const brush::Symmetry& symmetry = hand.symmetry;
    if (symmetry.mirror || symmetry.count > 1)
        handles.push_back({Handle::SymmetryCentre, centre(symmetry)});
    if (symmetry.mirror) {
        handles.push_back(
            {Handle::MirrorAxis, centre(symmetry) + axis_mm * direction(symmetry.axis_deg)});
    }
    if (hand.ruler) {
        handles.push_back({Handle::RulerStart, start(*hand.ruler)});
        handles.push_back({Handle::RulerEnd, end(*hand.ruler)});
        handles.push_back({Handle::RulerMiddle, 0.5 * (start(*hand.ruler) + end(*hand.ruler))});
    }
    if (hand.ellipse) {
        const brush::EllipseCurve& ellipse = *hand.ellipse;
        const glm::dvec2 along = direction(ellipse.turn_deg),
                         across = direction(ellipse.turn_deg + 90.0);
        handles.push_back({Handle::EllipseCentre, centre(ellipse)});
        handles.push_back({Handle::EllipseWidth, centre(ellipse) + ellipse.half_width_mm * along});
        handles.push_back({Handle::EllipseHeight, centre(ellipse) + ellipse.half_height_mm * across});
    }
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
    switch (handle) {
        case Handle::SymmetryCentre:
        case Handle::MirrorAxis:
            return dragged_symmetry(hand.symmetry, handle, place_mm, square);
        case Handle::RulerStart:
        case Handle::RulerEnd:
        case Handle::RulerMiddle:
            PASTOSO_CHECK(hand.ruler.has_value());
            return dragged_ruler(*hand.ruler, handle, place_mm, square);
        default:
            PASTOSO_CHECK(hand.ellipse.has_value());
            return dragged_ellipse(*hand.ellipse, handle, place_mm, square);
    }
}

}  // namespace pastoso::tools
