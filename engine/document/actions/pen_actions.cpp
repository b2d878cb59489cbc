#include "document/actions/pen_actions.hpp"

#include "core/error.hpp"
#include "document/living_painting.hpp"
#include "core/number_text.hpp"

namespace pastoso::document {

void check_time_order(const brush::PenSample& previous, const brush::PenSample& next) {
    if (next.time_s >= previous.time_s) return;
    throw core::InputError("the time " + core::number_text(next.time_s) + " s is earlier than " +
                           core::number_text(previous.time_s) + " s before it.");
}

void check_possible(const PenDown& pen, const LivingPainting& painting) {
    const bool on_canvas = pen.surface == Surface::Canvas;
    if (!painting.value.brush)
        throw core::InputError(on_canvas ? "the pen touches the canvas with no brush in hand."
                                         : "the pen touches the mixing well with no brush in hand.");
    if (on_canvas) check_paintable(painting.value.layers, painting.value.layers.active);
}

void check_possible(const PenMove& pen, const LivingPainting& painting) {
    if (painting.stroke) check_time_order(painting.last_sample, pen.sample);
}

UndoStep undo_step(const PenDown& pen, const LivingPainting& painting) {
    const std::string& brush = painting.value.brush->brush.preset.name;
    if (pen.surface == Surface::Well) return {.name = Table<PenDown>::kStepInWell, .brush = brush};
    return {.name = Table<PenDown>::kTraits.step,
            .brush = brush,
            .layer = painting.active_layer().look.name};
}

void apply(const PenDown& pen, LivingPainting& painting) {
    painting.last_sample = pen.sample;
    painting.begin_stroke_on(pen.surface);
    painting.value.flows.taken += painting.stroke->copied_paint();
    painting.stroke->begin(pen.sample);
    painting.finish_contacts();
}

void apply(const PenMove& pen, LivingPainting& painting) {
    if (!painting.stroke) return;
    painting.last_sample = pen.sample;
    painting.stroke->add(pen.sample);
    painting.finish_contacts();
}

void apply(const PenUp&, LivingPainting&) {}

}  // namespace pastoso::document
