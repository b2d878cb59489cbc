#include "document/actions/history_actions.hpp"

#include "document/living_painting.hpp"

#include <utility>
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

std::uint64_t touch_of(const PaintingValue& painting) {
    return painting.brush ? painting.brush->touch : 0;
}

/// A brush that was not touched since then gets back what it held. Any other stays in hand as it is, as
/// if it had been filled afresh, and what was on the old one counts as wiped off.
void return_brush_to(const PaintingValue& then, PaintingValue& now) {
    if (touch_of(now) == touch_of(then)) {
        now.brush = then.brush;
        return;
    }
    if (now.brush) now.flows.taken += now.brush->brush.contents();
    if (then.brush) now.flows.wiped += then.brush->brush.contents();
}

void return_to(const Moment& then, LivingPainting& painting) {
    PaintingValue& now = painting.value;
    const bool same_medium = then.value.medium == now.medium;
    painting.canvas.restore(then.value);
    return_well_to(then, same_medium, painting);
    now.selection = then.value.selection;
    now.tracing = then.value.tracing;
    now.flows = {.taken = then.value.flows.taken,
                 .wiped = then.value.flows.wiped,
                 .forgotten_run_off = difference(painting.canvas.solver.runoff(), then.run_off)};
    return_brush_to(then.value, now);
    restart(painting.canvas.solver, then.awake, same_medium && then.value.tilt == now.tilt);
}

}  // namespace

void apply(const Undo&, LivingPainting& painting) {
    if (painting.history.can_undo()) return_to(painting.history.step_back(painting.moment()), painting);
}

void apply(const Redo&, LivingPainting& painting) {
    if (painting.history.can_redo())
        return_to(painting.history.step_forward(painting.moment()), painting);
}

}  // namespace pastoso::document
