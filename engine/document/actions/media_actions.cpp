#include "document/actions/media_actions.hpp"

#include "core/check.hpp"
#include "document/living_painting.hpp"
#include "film/cell/drying.hpp"

namespace pastoso::document {

film::Medium medium_of(const UseMedium& use) {
    const film::Medium& bundled = film::find_medium(use.name);
    PASTOSO_CHECK(!use.own || use.own->name == bundled.name);
    return film::thinned(use.own ? *use.own : bundled, use.paint_share);
}

void check_whole(const UseMedium& use) {
    film::check_numbers(medium_of(use), core::message("the medium"));
}

void check_possible(const DryNow&, const LivingPainting& painting) {
    check_unlocked(painting.value.layers, painting.value.layers.active);
}

UndoStep undo_step(const DryNow&, const LivingPainting& painting) {
    return {.name = Table<DryNow>::kTraits.step, .layer = painting.active_layer().look.name};
}

void put_in_hand(const UseMedium& use, PaintingValue& painting) {
    painting.medium = {film::find_medium(use.name).name, use.own, use.paint_share};
}

void put_in_hand(const SetDrying& set, PaintingValue& painting) {
    painting.air = set.air;
}

UseMedium in_hand(std::type_identity<UseMedium>, const PaintingValue& painting) {
    return painting.medium;
}

SetDrying in_hand(std::type_identity<SetDrying>, const PaintingValue& painting) {
    return {painting.air};
}

void apply(const UseMedium& use, LivingPainting& painting) {
    PaintingValue& value = painting.value;
    const film::Medium next = medium_of(use);
    const auto holds_paint = [](const auto& brush) { return brush && brush->brush.holds_paint(); };
    const bool brushes_hold_paint = holds_paint(value.brush) || holds_paint(value.brush_aside);
    const bool begins_anew = !film::has_wet_paint(value.film) && !brushes_hold_paint && !value.well;
    if (next != painting.medium && begins_anew) value.film.consistencies = {};
    painting.medium = next;
    put_in_hand(use, value);
    painting.canvas.set_medium(next);
    if (!painting.well_solver) return;
    painting.well_solver->set_medium(next);
    value.well->consistencies.add(painting.well_solver->consistency());
}

void apply(const DryNow&, LivingPainting& painting) {
    film::dry_now(painting.value.film, painting.pool, painting.unmasked().get());
}

}  // namespace pastoso::document
