#include "document/actions/masking_actions.hpp"

#include "document/actions/field_checks.hpp"
#include "document/living_painting.hpp"

#include <utility>

namespace pastoso::document {
namespace {

void peel_to(Masking left, LivingPainting& painting) {
    painting.mask(std::move(left));
    painting.canvas.solver.wake_all();
}

}  // namespace

void check_whole(const MaskStripe& stripe) {
    check_between(core::message("number of the masking's points"), "",
                  static_cast<double>(stripe.line.size()), 1.0, kMostOutlinePoints);
    const core::Message name = core::message("masking's point");
    for (const CanvasPoint& point : stripe.line)
        check_point(name, point);
}

UndoStep undo_step(const MaskStripe& stripe, const LivingPainting&) {
    using Told = Table<MaskStripe>;
    if (stripe.peels) return {.name = Told::kPeeled};
    return {.name = stripe.straight_ends ? Told::kTape : Told::kTraits.step.value};
}

bool changes_anything(const MaskSelection&, const LivingPainting& painting) {
    const Selection& selection = painting.value.selection;
    return selection != nullptr && grid::chosen_cells(grid::hardened(*selection)) > 0;
}

bool changes_anything(const SelectMasked&, const LivingPainting& painting) {
    return painting.value.masking.cells != nullptr;
}

bool changes_anything(const PeelMasking&, const LivingPainting& painting) {
    return painting.value.masking.cells != nullptr;
}

void apply(const MaskStripe& stripe, LivingPainting& painting) {
    const PaintingValue& value = painting.value;
    grid::Mask area = area_of(stripe, value.film);
    if (value.selection)
        area = grid::combined(area, grid::hardened(*value.selection), Combination::Intersect);
    if (stripe.peels)
        peel_to(peeled(value.masking, area), painting);
    else
        painting.mask(
            laid_on(value.masking, area, stripe.straight_ends ? MaskingForm::Tape : MaskingForm::Fluid));
}

void apply(const MaskSelection&, LivingPainting& painting) {
    painting.mask(laid_on(painting.value.masking, grid::hardened(*painting.value.selection),
                          MaskingForm::Fluid));
}

void apply(const SelectMasked& select, LivingPainting& painting) {
    PaintingValue& value = painting.value;
    value.selection = combined(value.selection, *value.masking.cells, select.how);
}

void apply(const PeelMasking&, LivingPainting& painting) {
    peel_to({}, painting);
}

}  // namespace pastoso::document
