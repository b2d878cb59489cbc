#include "interactions/guide_lines.hpp"

#include "core/units.hpp"

#include <algorithm>
#include <cmath>

namespace pastoso::interactions {
namespace {

/// The part of the line p + t d, t in [low, high], that lies on the canvas (Liang and Barsky 1984).
class Clipper {
  public:
    Clipper(const glm::dvec2& canvas_mm, std::vector<glm::vec2>& lines)
        : canvas_mm_(canvas_mm), lines_(lines) {}

    void add(const glm::dvec2& p, const glm::dvec2& d, double low, double high) {
        for (int axis = 0; axis < 2; ++axis) {
            if (d[axis] == 0.0) {
                if (p[axis] < 0.0 || p[axis] > canvas_mm_[axis]) return;
                continue;
            }
            const double a = -p[axis] / d[axis], b = (canvas_mm_[axis] - p[axis]) / d[axis];
            low = std::max(low, std::min(a, b));
            high = std::min(high, std::max(a, b));
        }
        if (low >= high) return;
        lines_.emplace_back(p + low * d);
        lines_.emplace_back(p + high * d);
    }

  private:
    glm::dvec2 canvas_mm_;
    std::vector<glm::vec2>& lines_;
};

constexpr double kFar = 1e6;
constexpr int kEllipsePieces = 128;

void add_symmetry(const brush::Symmetry& symmetry, Clipper& clipper) {
    if (!symmetry.mirror && symmetry.count == 1) return;
    const glm::dvec2 centre{symmetry.centre_x_mm, symmetry.centre_y_mm};
    const double whole_deg = symmetry.mirror ? 180.0 : 360.0;
    for (int i = 0; i < symmetry.count; ++i) {
        const double angle = core::radians(symmetry.axis_deg + whole_deg * i / symmetry.count);
        clipper.add(centre, {std::cos(angle), std::sin(angle)}, symmetry.mirror ? -kFar : 0.0, kFar);
    }
}

void add_ellipse(const brush::EllipseCurve& ellipse, Clipper& clipper) {
    const double turn = core::radians(ellipse.turn_deg);
    const auto point = [&](int i) {
        const double angle = 2.0 * core::kPi * i / kEllipsePieces;
        const double x = ellipse.half_width_mm * std::cos(angle);
        const double y = ellipse.half_height_mm * std::sin(angle);
        return glm::dvec2(ellipse.centre_x_mm + x * std::cos(turn) - y * std::sin(turn),
                          ellipse.centre_y_mm + x * std::sin(turn) + y * std::cos(turn));
    };
    for (int i = 0; i < kEllipsePieces; ++i)
        clipper.add(point(i), point(i + 1) - point(i), 0.0, 1.0);
}

}  // namespace

std::vector<glm::vec2> guide_lines_mm(const tools::Hand& hand, const glm::dvec2& canvas_mm) {
    std::vector<glm::vec2> lines;
    Clipper clipper(canvas_mm, lines);
    add_symmetry(hand.symmetry, clipper);
    if (hand.ruler) {
        const brush::Ruler& ruler = *hand.ruler;
        const glm::dvec2 from{ruler.x1_mm, ruler.y1_mm};
        clipper.add(from, glm::dvec2{ruler.x2_mm, ruler.y2_mm} - from, -kFar, kFar);
    }
    if (hand.ellipse) add_ellipse(*hand.ellipse, clipper);
    return lines;
}

}  // namespace pastoso::interactions
