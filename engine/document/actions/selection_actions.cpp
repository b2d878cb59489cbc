#include "document/actions/selection_actions.hpp"

#include "document/actions/field_checks.hpp"
#include "document/living_painting.hpp"
#include "document/similar_colour.hpp"

#include <cmath>

namespace pastoso::document {
namespace {

template <class Range>
void check_order(const Range& select, const core::Message& name) {
    check_between(name, "mm", select.most_mm, select.least_mm, kMostPaint_mm);
}

void select(const grid::Mask& area, Combination how, LivingPainting& painting) {
    painting.value.selection = combined(painting.value.selection, area, how);
}

}  // namespace

void check_point(const core::Message& name, const CanvasPoint& point) {
    // An outline has points by the thousand: one that fits needs no message.
    const auto fits = [](double place_mm) { return std::abs(place_mm) <= kMaxPenPosition_mm; };
    if (fits(point.x_mm) && fits(point.y_mm)) return;
    check_between(core::message("x of the %1", name), "mm", point.x_mm, -kMaxPenPosition_mm,
                  kMaxPenPosition_mm);
    check_between(core::message("y of the %1", name), "mm", point.y_mm, -kMaxPenPosition_mm,
                  kMaxPenPosition_mm);
}

void check_whole(const SelectArea& select) {
    check_between(core::message("number of the outline's points"), "",
                  static_cast<double>(select.outline.size()), 3.0, kMostOutlinePoints);
    const core::Message name = core::message("outline's point");
    for (const CanvasPoint& point : select.outline)
        check_point(name, point);
}

void check_whole(const SelectByHeight& select) {
    check_order(select, core::message("most height"));
}

void check_whole(const SelectByWetness& select) {
    check_order(select, core::message("most thickness of wet paint"));
}

bool changes_anything(const InvertSelection&, const LivingPainting& painting) {
    return painting.value.selection != nullptr;
}

bool changes_anything(const SelectAll&, const LivingPainting& painting) {
    return painting.value.selection != nullptr;
}

void apply(const SelectArea& area, LivingPainting& painting) {
    select(area_of(area, painting.value.film), area.how, painting);
}

void apply(const SelectByHeight& heights, LivingPainting& painting) {
    const PaintingValue& value = painting.value;
    select(area_of(heights, value.film, value.bare->support_mm), heights.how, painting);
}

void apply(const SelectByWetness& wetness, LivingPainting& painting) {
    select(area_of(wetness, painting.value.film), wetness.how, painting);
}

void apply(const SelectPaint& paint, LivingPainting& painting) {
    select(area_of(paint, painting.value.film, painting.canvas.base_mm()), paint.how, painting);
}

void apply(const SelectSimilarColour& colour, LivingPainting& painting) {
    select(area_of(colour, painting.canvas.view(), kPrimedGround, painting.pool), colour.how, painting);
}

void apply(const InvertSelection&, LivingPainting& painting) {
    painting.value.selection = inverted(painting.value.selection);
}

void apply(const SelectAll&, LivingPainting& painting) {
    painting.value.selection.reset();
}

}  // namespace pastoso::document
