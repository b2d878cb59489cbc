#include "interactions/guide_lines.hpp"

#include "core/units.hpp"
#include "interactions/canvas_clip.hpp"

#include <cmath>

namespace pastoso::interactions {
namespace {

struct LineDrawer {
    CanvasClip& clip;

    void operator()(const brush::Symmetry& symmetry) const {
        if (!symmetry.mirror && symmetry.count == 1) return;
        const glm::dvec2 centre{symmetry.centre_x_mm, symmetry.centre_y_mm};
        const double whole_deg = symmetry.mirror ? 180.0 : 360.0;
        for (int i = 0; i < symmetry.count; ++i) {
            const double angle = core::radians(symmetry.axis_deg + whole_deg * i / symmetry.count);
            clip.add(centre, {std::cos(angle), std::sin(angle)}, symmetry.mirror ? -kEndless : 0.0,
                     kEndless);
        }
    }
    void operator()(const brush::Ruler& ruler) const {
        const glm::dvec2 from{ruler.x1_mm, ruler.y1_mm};
        clip.add(from, glm::dvec2{ruler.x2_mm, ruler.y2_mm} - from, -kEndless, kEndless);
    }
    void operator()(const brush::EllipseCurve& ellipse) const { clip.add(ellipse); }
    void operator()(const brush::VanishingPoints& points) const {
        const double level = core::radians(points.level_deg);
        clip.add({points.x1_mm, points.y1_mm}, {std::cos(level), std::sin(level)}, -kEndless, kEndless);
    }
    void operator()(const auto&) const {}
};

}  // namespace

std::vector<glm::vec2> guide_lines_mm(const tools::Hand& hand, const glm::dvec2& canvas_mm) {
    CanvasClip clip(canvas_mm);
    const LineDrawer draw{clip};
    draw(hand.symmetry);
    std::visit(draw, hand.laid.form);
    return clip.take_lines();
}

}  // namespace pastoso::interactions
