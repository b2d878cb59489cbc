#include "interactions/wet_mark.hpp"

#include "appearance/screen_colours.hpp"
#include "document/actions/actions.hpp"
#include "document/layers.hpp"
#include "document/painting.hpp"

#include <variant>

#include <QPainter>
#include <QPainterPath>
#include <glm/geometric.hpp>

namespace pastoso::interactions {
namespace {

/// Of a film that hides all: what it covers still shows a little, as a stroke's grooves do.
constexpr double kStrength = 0.95;

/// Places of the brush that lie nearer to each other than so many pixels make no other mark.
constexpr double kGap_px = 5.0;

bool is_uppermost(const document::LayerStack& stack) {
    for (std::size_t place = stack.active + 1; place < stack.layers.size(); ++place)
        if (effective_look(stack, place).visible) return false;
    return effective_look(stack, stack.active).visible;
}

/// Elsewhere a mark would be where the paint is not.
bool paints_what_is_seen(const document::Snapshot& shown) {
    if (shown.selection != nullptr || shown.masking.cells != nullptr) return false;
    if (shown.layers == nullptr) return true;
    return is_uppermost(*shown.layers) &&
           !effective_look(*shown.layers, shown.layers->active).bare_locked &&
           !clipped_to(*shown.layers, shown.layers->active);
}

/// A straight line is painted when the pen lifts.
bool is_line(const brush::HandAids& aids) {
    return std::holds_alternative<brush::StraightLine>(aids.guide.form);
}

bool lays_films(const brush::Preset& tool) {
    return tool.kind == brush::ToolKind::Contact && !tool.exchange.absorbs;
}

QPainterPath path_of(const std::vector<std::vector<glm::vec2>>& outlines_mm,
                     const brush::Placement& copy, const view::Overlay& overlay, double point_px) {
    QPainterPath path;
    path.setFillRule(Qt::WindingFill);
    for (const auto& outline : outlines_mm) {
        QPolygonF points;
        for (const glm::vec2& mm : outline) {
            const glm::dvec2 there(copy.xx * mm.x + copy.xy * mm.y + copy.x_mm,
                                   copy.yx * mm.x + copy.yy * mm.y + copy.y_mm);
            const glm::dvec2 px = overlay.canvas.device_px(there);
            points << QPointF(px.x, px.y) / point_px;
        }
        path.addPolygon(points);
        path.closeSubpath();
    }
    return path;
}

}  // namespace

void WetMark::note(const document::Action& action, std::uint64_t number, const tools::Hand& hand,
                   const BrushOutline& outline) {
    if (const auto* down = std::get_if<document::PenDown>(&action))
        begin(*down, number, hand, outline);
    else if (const auto* move = std::get_if<document::PenMove>(&action))
        ahead_.add(move->sample, number);
    else if (const auto* turn = std::get_if<document::TurnStroke>(&action))
        ahead_.turn(turn->rotation_deg);
    else if (std::holds_alternative<document::PenUp>(action))
        ahead_.end(number);
}

void WetMark::begin(const document::PenDown& down, std::uint64_t number, const tools::Hand& hand,
                    const BrushOutline& outline) {
    ahead_ = {};
    const brush::HandAids aids{hand.stabiliser, hand.guide};
    const bool on_canvas = down.surface == document::Surface::Canvas;
    if (!on_canvas || !lays_films(outline.tool()) || is_line(aids)) return;
    copies_ = brush::placements(hand.symmetry);
    ahead_.begin(brush::HandPath(outline.tool(), outline.tip(), aids), down.sample, number);
}

bool WetMark::draw(const document::Snapshot& shown, const view::Overlay& overlay,
                   const BrushOutline& outline) {
    ahead_.shown(shown.posted_actions);
    const auto& colour = !ahead_.is_down() && paint_.dipped ? paint_.dipped : paint_.held;
    if (!colour || !paints_what_is_seen(shown)) return false;
    const auto outlines_mm = outline.swept_mm(ahead_.places(), kGap_px * overlay.px_mm);
    if (outlines_mm.empty()) return false;
    const auto [red, green, blue] = colour->colour;
    const QColor wet = appearance::shown_in_painting(
        QColor(red, green, blue, static_cast<int>(255.0 * kStrength * colour->opacity + 0.5)));
    const double point_px = overlay.px_mm * glm::length(overlay.canvas.px_from_mm[0]);
    overlay.painter.draw([&](QPainter& painter) {
        painter.setRenderHint(QPainter::Antialiasing);
        for (const brush::Placement& copy : copies_)
            painter.fillPath(path_of(outlines_mm, copy, overlay, point_px), wet);
    });
    return true;
}

}  // namespace pastoso::interactions
