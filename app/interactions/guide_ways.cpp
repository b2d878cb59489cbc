#include "interactions/guide_ways.hpp"

#include "core/units.hpp"
#include "interactions/canvas_clip.hpp"

#include <algorithm>
#include <cmath>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

namespace pastoso::interactions {
namespace {

/// Beside a ruler, about an ellipse, and from a vanishing point there are about so many.
constexpr int kWays = 12;
constexpr int kMostLines = 100;

struct WayDrawer {
    bool reaches;
    const glm::dvec2& canvas_mm;
    CanvasClip& clip;

    void operator()(const brush::Ruler& ruler) const;
    void operator()(const brush::EllipseCurve& ellipse) const;
    void operator()(const brush::VanishingPoints& points) const;
    void operator()(const brush::Grid& grid) const;
    void operator()(const auto&) const {}

    double diagonal_mm() const { return glm::length(canvas_mm); }
    void add_parallels(const glm::dvec2& through, const glm::dvec2& along, double spacing_mm) const;
    void add_rays(const glm::dvec2& from) const;
};

glm::dvec2 direction(double angle_deg) {
    return {std::cos(core::radians(angle_deg)), std::sin(core::radians(angle_deg))};
}

/// `along` is of unit length.
void WayDrawer::add_parallels(const glm::dvec2& through, const glm::dvec2& along,
                              double spacing_mm) const {
    const glm::dvec2 across{-along.y, along.x};
    const double middle_mm = glm::dot(0.5 * canvas_mm - through, across);
    const double lines = diagonal_mm() / spacing_mm;
    const double step = std::max(1.0, std::ceil(lines / kMostLines));
    const double first = step * std::ceil((middle_mm - 0.5 * diagonal_mm()) / (step * spacing_mm));
    for (double i = first; i * spacing_mm <= middle_mm + 0.5 * diagonal_mm(); i += step)
        clip.add(through + i * spacing_mm * across, along, -kEndless, kEndless);
}

void WayDrawer::operator()(const brush::Ruler& ruler) const {
    if (reaches) return;
    const glm::dvec2 from{ruler.x1_mm, ruler.y1_mm};
    add_parallels(from, glm::normalize(glm::dvec2(ruler.x2_mm, ruler.y2_mm) - from),
                  diagonal_mm() / kWays);
}

void WayDrawer::operator()(const brush::EllipseCurve& ellipse) const {
    if (reaches) return;
    constexpr double kStep = 0.5;
    for (int i = 1; i <= kWays; ++i) {
        if (i * kStep == 1.0) continue;
        brush::EllipseCurve other = ellipse;
        other.half_width_mm *= i * kStep;
        other.half_height_mm *= i * kStep;
        clip.add(other);
    }
}

/// All around from a point on the canvas; over all of the canvas from one beside it.
void WayDrawer::add_rays(const glm::dvec2& from) const {
    const bool on_canvas = from == glm::clamp(from, glm::dvec2(0.0), canvas_mm);
    const glm::dvec2 to_middle = 0.5 * canvas_mm - from;
    const double middle_deg = core::degrees(std::atan2(to_middle.y, to_middle.x));
    double most_deg = 180.0;
    if (!on_canvas) {
        most_deg = 0.0;
        for (const glm::dvec2& corner :
             {glm::dvec2(0.0), glm::dvec2(canvas_mm.x, 0.0), glm::dvec2(0.0, canvas_mm.y), canvas_mm}) {
            const glm::dvec2 way = corner - from;
            const double angle_deg = core::degrees(std::atan2(way.y, way.x));
            most_deg = std::max(most_deg, std::abs(std::remainder(angle_deg - middle_deg, 360.0)));
        }
    }
    const int rays = on_canvas ? 2 * kWays : kWays;
    for (int i = 0; i < rays; ++i) {
        const double share = (2.0 * i + 1.0) / rays - 1.0;
        clip.add(from, direction(middle_deg + share * most_deg), 0.0, kEndless);
    }
}

void WayDrawer::operator()(const brush::VanishingPoints& points) const {
    add_rays({points.x1_mm, points.y1_mm});
    if (points.count > 1) add_rays({points.x2_mm, points.y2_mm});
    if (points.count > 2) add_rays({points.x3_mm, points.y3_mm});
}

void WayDrawer::operator()(const brush::Grid& grid) const {
    const glm::dvec2 through{grid.x_mm, grid.y_mm};
    add_parallels(through, direction(grid.direction_deg), grid.spacing_mm);
    add_parallels(through, direction(grid.other_direction_deg), grid.other_spacing_mm);
}

}  // namespace

std::vector<glm::vec2> ways_mm(const brush::PenGuide& guide, const glm::dvec2& canvas_mm) {
    CanvasClip clip(canvas_mm);
    std::visit(WayDrawer{guide.reach_mm > 0.0, canvas_mm, clip}, guide.form);
    return clip.take_lines();
}

}  // namespace pastoso::interactions
