#include "tools/laid_guide.hpp"

#include "core/units.hpp"

#include <algorithm>
#include <cmath>

namespace pastoso::tools {
namespace {

/// The form as it is, or another one where it is of another type.
template <class Form>
Form kept(const brush::PenGuide& guide, const Form& otherwise) {
    const Form* form = std::get_if<Form>(&guide.form);
    return form != nullptr ? *form : otherwise;
}

double reach_of(const brush::PenGuide& guide) {
    return guide.reach_mm > 0.0 ? guide.reach_mm : brush::PenGuide{}.reach_mm;
}

brush::Ruler level_ruler(const glm::dvec2& canvas_mm) {
    const double middle_mm = 0.5 * canvas_mm.y;
    return {0.1 * canvas_mm.x, middle_mm, 0.9 * canvas_mm.x, middle_mm};
}

brush::EllipseCurve circle(const glm::dvec2& canvas_mm) {
    const double half_mm = 0.3 * std::min(canvas_mm.x, canvas_mm.y);
    return {0.5 * canvas_mm.x, 0.5 * canvas_mm.y, half_mm, half_mm, 0.0};
}

/// One point lies in the middle; two on the left and right of the canvas, and the third far below it.
brush::VanishingPoints points(int count, const glm::dvec2& canvas_mm) {
    const double middle_mm = 0.5 * canvas_mm.x, horizon_mm = 0.4 * canvas_mm.y;
    return {.count = count,
            .x1_mm = count == 1 ? middle_mm : -0.4 * canvas_mm.x,
            .y1_mm = horizon_mm,
            .x2_mm = 1.4 * canvas_mm.x,
            .y2_mm = horizon_mm,
            .x3_mm = middle_mm,
            .y3_mm = 3.0 * canvas_mm.y};
}

brush::VanishingPoints with_count(brush::VanishingPoints points, int count) {
    points.count = count;
    return with_horizon(points);
}

brush::Grid grid(const glm::dvec2& canvas_mm) {
    return {.x_mm = 0.5 * canvas_mm.x, .y_mm = 0.5 * canvas_mm.y};
}

}  // namespace

GuideKind kind_of(const brush::PenGuide& guide) {
    struct Kind {
        bool reaches;
        GuideKind operator()(const brush::Ruler&) const {
            return reaches ? GuideKind::Ruler : GuideKind::ParallelRuler;
        }
        GuideKind operator()(const brush::EllipseCurve&) const {
            return reaches ? GuideKind::Ellipse : GuideKind::ConcentricEllipse;
        }
        GuideKind operator()(const brush::VanishingPoints& points) const {
            if (points.count == 1) return GuideKind::OnePoint;
            return points.count == 2 ? GuideKind::TwoPoints : GuideKind::ThreePoints;
        }
        GuideKind operator()(const brush::Grid&) const { return GuideKind::Grid; }
        GuideKind operator()(std::monostate) const { return GuideKind::None; }
        GuideKind operator()(const brush::StraightLine&) const { return GuideKind::None; }
    };
    return std::visit(Kind{guide.reach_mm > 0.0}, guide.form);
}

brush::PenGuide as_kind(const brush::PenGuide& guide, GuideKind kind, const glm::dvec2& canvas_mm) {
    const auto laid = [&](const auto& form, double reach_mm) {
        return brush::PenGuide{.form = form, .reach_mm = reach_mm, .strength = guide.strength};
    };
    const auto perspective = [&](int count) {
        return laid(with_count(kept(guide, points(count, canvas_mm)), count), reach_of(guide));
    };
    switch (kind) {
        case GuideKind::Ruler:
            return laid(kept(guide, level_ruler(canvas_mm)), reach_of(guide));
        case GuideKind::ParallelRuler:
            return laid(kept(guide, level_ruler(canvas_mm)), 0.0);
        case GuideKind::Ellipse:
            return laid(kept(guide, circle(canvas_mm)), reach_of(guide));
        case GuideKind::ConcentricEllipse:
            return laid(kept(guide, circle(canvas_mm)), 0.0);
        case GuideKind::OnePoint:
            return perspective(1);
        case GuideKind::TwoPoints:
            return perspective(2);
        case GuideKind::ThreePoints:
            return perspective(3);
        case GuideKind::Grid:
            return laid(kept(guide, grid(canvas_mm)), reach_of(guide));
        case GuideKind::None:
            break;
    }
    return laid(std::monostate{}, reach_of(guide));
}

brush::VanishingPoints with_horizon(brush::VanishingPoints points) {
    const double x_mm = points.x2_mm - points.x1_mm, y_mm = points.y2_mm - points.y1_mm;
    if (points.count < 2 || (x_mm == 0.0 && y_mm == 0.0)) return points;
    points.level_deg = core::degrees(std::atan(y_mm / x_mm));
    points.upright_deg = points.level_deg + 90.0;
    return points;
}

}  // namespace pastoso::tools
