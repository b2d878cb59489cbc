#include "document/actions/margin_actions.hpp"

#include "document/living_painting.hpp"
#include "grid/feathering.hpp"

namespace pastoso::document {
namespace {

bool is_limited(const LivingPainting& painting) {
    return painting.value.selection != nullptr;
}

template <class Margin>
void change_selection(const Margin& margin, LivingPainting& painting) {
    PaintingValue& value = painting.value;
    value.selection = changed_by(margin, value.selection, value.film.cell_mm);
}

}  // namespace

bool changes_anything(const GrowSelection&, const LivingPainting& painting) {
    return is_limited(painting);
}

bool changes_anything(const ShrinkSelection&, const LivingPainting& painting) {
    return is_limited(painting);
}

bool changes_anything(const BorderSelection&, const LivingPainting& painting) {
    return is_limited(painting);
}

bool changes_anything(const FeatherSelection& feather, const LivingPainting& painting) {
    return is_limited(painting) &&
           feather.radius_mm / painting.value.film.cell_mm >= grid::kLeastFeather;
}

void apply(const GrowSelection& grow, LivingPainting& painting) {
    change_selection(grow, painting);
}

void apply(const ShrinkSelection& shrink, LivingPainting& painting) {
    change_selection(shrink, painting);
}

void apply(const BorderSelection& border, LivingPainting& painting) {
    change_selection(border, painting);
}

void apply(const FeatherSelection& feather, LivingPainting& painting) {
    change_selection(feather, painting);
}

}  // namespace pastoso::document
