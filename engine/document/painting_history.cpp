// What Undo returns to.
#include "document/painting_parts.hpp"

#include <utility>
#include <vector>

namespace pastoso::document {

void Painting::Parts::operator()(const Undo&) {
    end_stroke();
    if (history.can_undo()) return_to(history.step_back(moment()));
}

void Painting::Parts::operator()(const Redo&) {
    end_stroke();
    if (history.can_redo()) return_to(history.step_forward(moment()));
}

Step Painting::Parts::stroke_step(Surface surface) const {
    if (surface == Surface::Well) return {Step::Kind::StrokeInWell, brush->preset.name};
    return {Step::Kind::Stroke, brush->preset.name, active_name()};
}

Step Painting::Parts::layer_step(Step::Kind kind, LayerId layer) const {
    return {kind, {}, canvas.stack().layers[place_of(canvas.stack(), layer)].look.name};
}

Step Painting::Parts::group_step(Step::Kind kind, GroupId group) const {
    return {kind, {}, group_of(canvas.stack(), group).look.name};
}

Moment Painting::Parts::moment() const {
    Moment moment{.bare = bare,
                  .canvas = {film, solver.awake_tiles()},
                  .layers = canvas.stack(),
                  .brush = brush,
                  .medium = used_medium,
                  .selection = selection,
                  .tracing = tracing,
                  .tilt = tilt,
                  .brush_use = brush_use,
                  .taken = taken,
                  .wiped = wiped,
                  .run_off = run_off()};
    if (well) moment.well = {well->film, well->solver.awake_tiles()};
    return moment;
}

void Painting::Parts::return_to(const Moment& then) {
    canvas.restore(then.canvas.film, then.layers, then.bare == bare ? nullptr : &then.bare->support_mm);
    bare = then.bare;
    return_well_to(then);
    selection = then.selection;
    tracing = then.tracing;
    if (then.medium != used_medium) film.varied = true;
    taken = then.taken;
    wiped = then.wiped;
    forgotten_run_off = difference(solver.runoff(), then.run_off);
    if (brush_use == then.brush_use) {
        brush = then.brush;
    } else {
        if (brush) taken += brush->contents();
        if (then.brush) wiped += then.brush->contents();
    }
    restart(solver, then.canvas.awake, then.medium == used_medium && then.tilt == tilt);
}

void Painting::Parts::return_well_to(const Moment& then) {
    if (!then.well) {
        well.reset();
        return;
    }
    used_well().film = then.well->film;
    restart(well->solver, then.well->awake, then.medium == used_medium);
}

void Painting::Parts::restart(film::Solver& solver, const std::vector<bool>& awake, bool same_forces) {
    solver.restart(awake);
    if (!same_forces) solver.wake_all();
}

}  // namespace pastoso::document
