#include "interactions/brush_outline.hpp"

#include "brush/footprint.hpp"
#include "brush/hand_pose.hpp"
#include "core/units.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include <glm/geometric.hpp>

namespace pastoso::interactions {
namespace {

constexpr int kPoints = 96;

/// Seen from above, of a handle that lies flat.
constexpr double kHandle_px = 48.0;

/// A pen that stands so straight has no direction that a hand means.
constexpr double kUpright_deg = 4.0, kFlattest_deg = 89.0;

glm::dvec2 direction(int point) {
    const double angle = 2.0 * core::kPi * point / kPoints;
    return {std::cos(angle), std::sin(angle)};
}

double slope(double tilt_deg) {
    return std::tan(core::radians(std::clamp(tilt_deg, -kFlattest_deg, kFlattest_deg)));
}

/// The ferrule's end: where all hairs of an upright brush are rooted.
std::vector<glm::vec2> roots_mm(const brush::Tip& tip, const brush::HandPose& pose) {
    std::vector<glm::vec2> roots;
    for (const brush::Bristle& bristle : tip.bristles) {
        const double x = bristle.root_x_mm, y = bristle.root_y_mm;
        roots.emplace_back(x * pose.cos_rotation - y * pose.sin_rotation,
                           x * pose.sin_rotation + y * pose.cos_rotation);
    }
    return roots;
}

/// Places far enough from one another, and the last one.
std::vector<brush::PenSample> apart(const std::vector<brush::PenSample>& places, double gap_mm) {
    std::vector<brush::PenSample> kept;
    for (const brush::PenSample& place : places) {
        const bool is_last = &place == &places.back();
        if (kept.empty() || is_last ||
            std::hypot(place.x_mm - kept.back().x_mm, place.y_mm - kept.back().y_mm) >= gap_mm)
            kept.push_back(place);
    }
    return kept;
}

/// Nobody sees how little another outline a brush has that is held so.
bool is_held_alike(const brush::PenSample& a, const brush::PenSample& b) {
    constexpr double kPressure = 0.02, kAngle_deg = 1.5;
    return std::abs(a.pressure - b.pressure) < kPressure &&
           std::abs(a.tilt_x_deg - b.tilt_x_deg) < kAngle_deg &&
           std::abs(a.tilt_y_deg - b.tilt_y_deg) < kAngle_deg &&
           std::abs(a.rotation_deg - b.rotation_deg) < kAngle_deg;
}

/// Around two lines of hull_mm(): in every direction, the point that lies farther there.
std::vector<glm::vec2> around_both(std::vector<glm::vec2> line, const std::vector<glm::vec2>& other) {
    for (int i = 0; i < kPoints; ++i) {
        const glm::vec2 outward(direction(i));
        if (glm::dot(other[i], outward) > glm::dot(line[i], outward)) line[i] = other[i];
    }
    return line;
}

/// Those of the convex hull, among which are the farthest points of every direction (A. M. Andrew,
/// 1979).
std::vector<glm::vec2> corners(std::vector<glm::vec2> points) {
    const auto before = [](const glm::vec2& a, const glm::vec2& b) {
        return a.x < b.x || (a.x == b.x && a.y < b.y);
    };
    const auto turns_left = [](const glm::vec2& a, const glm::vec2& b, const glm::vec2& c) {
        return (b.x - a.x) * (c.y - a.y) > (b.y - a.y) * (c.x - a.x);
    };
    std::sort(points.begin(), points.end(), before);
    std::vector<glm::vec2> hull;
    for (int side = 0; side < 2; ++side) {
        const std::size_t first = hull.size();
        for (const glm::vec2& point : points) {
            while (hull.size() >= first + 2 && !turns_left(hull[hull.size() - 2], hull.back(), point))
                hull.pop_back();
            hull.push_back(point);
        }
        std::reverse(points.begin(), points.end());
    }
    return hull;
}

}  // namespace

BrushOutline::BrushOutline(const brush::Preset& tool) : tool_(tool), tip_(brush::make_tip(tool, 1)) {}

void BrushOutline::set_tool(const brush::Preset& tool) {
    if (!(tool == tool_)) *this = BrushOutline(tool);
}

std::vector<glm::vec2> BrushOutline::around_mm(const brush::PenSample& pen) const {
    const brush::HandPose pose = brush::hand_pose(tool_.dynamics, {.pen = pen});
    if (tool_.kind != brush::ToolKind::Contact)
        return hull_mm({{0.0F, 0.0F}}, tip_.half_width_mm * std::max(pose.spread, 0.05));
    const std::vector<glm::vec2> touched = brush::tips_set_down(tool_, tip_, pose);
    return hull_mm(touched.empty() ? roots_mm(tip_, pose) : touched,
                   std::max(tip_.radius_mm, tip_.lane_mm));
}

std::vector<std::vector<glm::vec2>> BrushOutline::swept_mm(const std::vector<brush::PenSample>& places,
                                                           double gap_mm) const {
    std::vector<std::vector<glm::vec2>> swept;
    std::vector<glm::vec2> outline, before;
    const std::vector<brush::PenSample> kept = apart(places, gap_mm);
    const brush::PenSample* outlined = nullptr;
    for (const brush::PenSample& place : kept) {
        if (outlined == nullptr || !is_held_alike(*outlined, place)) {
            outline = around_mm(place);
            outlined = &place;
        }
        std::vector<glm::vec2> line = outline;
        for (glm::vec2& point : line)
            point += glm::vec2(place.x_mm, place.y_mm);
        if (!before.empty()) swept.push_back(around_both(before, line));
        before = std::move(line);
    }
    if (kept.size() == 1) swept.push_back(std::move(before));
    return swept;
}

/// In every direction, the point of the circles that lies farthest there.
std::vector<glm::vec2> hull_mm(const std::vector<glm::vec2>& centres_mm, double radius_mm) {
    const std::vector<glm::vec2> corners_mm = corners(centres_mm);
    std::vector<glm::vec2> line;
    line.reserve(kPoints);
    for (int i = 0; i < kPoints; ++i) {
        const glm::vec2 outward(direction(i));
        const auto farthest = std::max_element(
            corners_mm.begin(), corners_mm.end(),
            [&](const auto& a, const auto& b) { return glm::dot(a, outward) < glm::dot(b, outward); });
        line.push_back(*farthest + static_cast<float>(radius_mm) * outward);
    }
    return line;
}

glm::dvec2 handle_px(double tilt_x_deg, double tilt_y_deg) {
    const glm::dvec2 lean(slope(tilt_x_deg), slope(tilt_y_deg));
    const double tangent = glm::length(lean);
    if (tangent < slope(kUpright_deg)) return {};
    // Of a handle of unit length, its foot to its end: the sine of the tilt.
    return kHandle_px / std::sqrt(1.0 + tangent * tangent) * lean;
}

}  // namespace pastoso::interactions
