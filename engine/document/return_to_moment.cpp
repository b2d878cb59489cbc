// A painting becomes again what it was at a moment.

#include "core/check.hpp"
#include "document/living_painting.hpp"

#include <vector>

namespace pastoso::document {
namespace {

/// What rested then rests now, unless other forces act on it.
void restart(film::Solver& solver, const std::vector<bool>& awake, bool same_forces) {
    solver.restart(awake);
    if (!same_forces) solver.wake_all();
}

void return_well_to(const Moment& then, bool same_medium, LivingPainting& painting) {
    if (!then.value.well) {
        painting.well_solver.reset();
        painting.value.well.reset();
        return;
    }
    film::Solver& solver = painting.used_well();
    *painting.value.well = *then.value.well;
    restart(solver, then.well_awake, same_medium);
}

bool is_same(const std::optional<BrushInHand>& a, const std::optional<BrushInHand>& b) {
    return a.has_value() == b.has_value() && (!a || a->touch == b->touch);
}

bool is_same(const BrushAside& a, const BrushAside& b) {
    return a == b;
}

/// A brush that was not touched since then gets back what it held. Any other stays in hand as it is, as
/// if it had been filled afresh, and what was on the old one counts as wiped off.
template <class Brush>
void return_brush_to(const Brush& then, Brush& now, PaintFlows& flows) {
    if (is_same(now, then)) {
        now = then;
        return;
    }
    if (now) flows.taken += now->brush.contents();
    if (then) flows.wiped += then->brush.contents();
}

}  // namespace

void LivingPainting::return_to(const Moment& then) {
    PASTOSO_CHECK(!stroke);
    const bool same_medium = then.value.medium == value.medium;
    canvas.restore(then.value);
    return_well_to(then, same_medium, *this);
    value.selection = then.value.selection;
    mask(then.value.masking);
    value.tracing = then.value.tracing;
    value.references = then.value.references;
    value.flows = {.taken = then.value.flows.taken,
                   .wiped = then.value.flows.wiped,
                   .forgotten_run_off = difference(canvas.solver.runoff(), then.run_off)};
    return_brush_to(then.value.brush, value.brush, value.flows);
    return_brush_to(then.value.brush_aside, value.brush_aside, value.flows);
    restart(canvas.solver, then.awake, same_medium && then.value.tilt == value.tilt);
}

}  // namespace pastoso::document
