#include "tools/canvas_resizing.hpp"

#include <utility>
#include <variant>

namespace pastoso::tools {
namespace {

/// Half for the middle.
double share_before(int anchor) {
    return 0.5 * anchor;
}

brush::Ruler moved(brush::Ruler ruler, const glm::dvec2& shift_mm) {
    ruler.x1_mm += shift_mm.x;
    ruler.y1_mm += shift_mm.y;
    ruler.x2_mm += shift_mm.x;
    ruler.y2_mm += shift_mm.y;
    return ruler;
}

template <class Centred>
Centred moved(Centred guide, const glm::dvec2& shift_mm) {
    guide.centre_x_mm += shift_mm.x;
    guide.centre_y_mm += shift_mm.y;
    return guide;
}

brush::PenGuide moved(brush::PenGuide guide, const glm::dvec2& shift_mm) {
    if (const auto* ruler = std::get_if<brush::Ruler>(&guide.form)) guide.form = moved(*ruler, shift_mm);
    if (const auto* ellipse = std::get_if<brush::EllipseCurve>(&guide.form))
        guide.form = moved(*ellipse, shift_mm);
    return guide;
}

}  // namespace

document::ResizeCanvas anchored(const document::CanvasSettings& canvas, double width_mm,
                                double height_mm, const Anchor& anchor) {
    return {share_before(anchor.column) * (canvas.width_mm - width_mm),
            share_before(anchor.row) * (canvas.height_mm - height_mm), width_mm, height_mm};
}

Margins margins_of(const document::ResizeCanvas& resize, const document::CanvasSettings& canvas) {
    const grid::Shape before = document::canvas_shape(canvas);
    const grid::Extent after = document::extent_of(resize, canvas);
    const auto mm = [&](int cells) { return cells / canvas.px_per_mm; };
    return {mm(-after.x0), mm(-after.y0), mm(after.x0 + after.shape.width - before.width),
            mm(after.y0 + after.shape.height - before.height)};
}

std::optional<document::ResizeCanvas> cropped_to(const document::Selection& selection,
                                                 const document::CanvasSettings& canvas) {
    if (selection == nullptr) return std::nullopt;
    const grid::Rect cells = grid::chosen_area(*selection);
    if (cells.empty() || cells == document::canvas_shape(canvas).cells()) return std::nullopt;
    const auto mm = [&](int count) { return count / canvas.px_per_mm; };
    return document::ResizeCanvas{mm(cells.x0), mm(cells.y0), mm(cells.width()), mm(cells.height())};
}

glm::dvec2 shift_mm(const document::CanvasSettings& before, const document::CanvasSettings& after) {
    return {before.support_x_mm - after.support_x_mm, before.support_y_mm - after.support_y_mm};
}

Hand moved_along(Hand hand, const glm::dvec2& shift_mm) {
    hand.symmetry = moved(hand.symmetry, shift_mm);
    if (hand.ruler) hand.ruler = moved(*hand.ruler, shift_mm);
    if (hand.ellipse) hand.ellipse = moved(*hand.ellipse, shift_mm);
    hand.guide = moved(hand.guide, shift_mm);
    hand.air.fan_x_mm += shift_mm.x;
    hand.air.fan_y_mm += shift_mm.y;
    return hand;
}

}  // namespace pastoso::tools
