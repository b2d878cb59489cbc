#include "document/actions/pen_actions.hpp"

#include "core/error.hpp"
#include "document/living_painting.hpp"

#include <utility>

namespace pastoso::document {
namespace {

/// Begins the stroke that painting.begun tells of.
void lay_samples(LivingPainting& painting) {
    const StrokeBegun& begun = *painting.begun;
    painting.begin_stroke_on(begun.surface);
    painting.value.flows.taken += painting.stroke->copied_paint();
    painting.stroke->begin(begun.samples.front());
    for (std::size_t i = 1; i < begun.samples.size(); ++i)
        painting.stroke->add(begun.samples[i]);
    painting.finish_contacts();
}

}  // namespace

void check_time_order(const brush::PenSample& previous, const brush::PenSample& next) {
    if (next.time_s >= previous.time_s) return;
    throw core::InputError("the time %1 s is earlier than %2 s before it.", next.time_s,
                           previous.time_s);
}

void check_possible(const PenDown& pen, const LivingPainting& painting) {
    const bool on_canvas = pen.surface == Surface::Canvas;
    if (!painting.value.brush)
        throw core::InputError(
            on_canvas ? core::message("the pen touches the canvas with no brush in hand.")
                      : core::message("the pen touches the mixing well with no brush in hand."));
    if (on_canvas) check_paintable(painting.value.layers, painting.value.layers.active);
}

void check_possible(const PenMove& pen, const LivingPainting& painting) {
    if (painting.stroke) check_time_order(painting.begun->samples.back(), pen.sample);
}

UndoStep undo_step(const PenDown& pen, const LivingPainting& painting) {
    const std::string& brush = painting.value.brush->brush.preset.name;
    if (pen.surface == Surface::Well) return {.name = Table<PenDown>::kStepInWell, .brush = brush};
    return {.name = Table<PenDown>::kTraits.step,
            .brush = brush,
            .layer = painting.active_layer().look.name};
}

void apply(const PenDown& pen, LivingPainting& painting) {
    painting.begun =
        StrokeBegun{.before = painting.moment(), .surface = pen.surface, .samples = {pen.sample}};
    lay_samples(painting);
}

void apply(const PenMove& pen, LivingPainting& painting) {
    if (!painting.stroke) return;
    painting.begun->samples.push_back(pen.sample);
    painting.stroke->add(pen.sample);
    painting.finish_contacts();
}

void apply(const PenUp&, LivingPainting&) {}

void apply(const TurnStroke& turn, LivingPainting& painting) {
    if (!painting.stroke || !painting.begun->before) return;
    StrokeBegun begun = *std::move(painting.begun);
    std::optional<AwaitedStep> awaited = std::exchange(painting.awaited_step, std::nullopt);
    painting.end_stroke();
    painting.awaited_step = std::move(awaited);
    painting.return_to(*begun.before);
    begun.before.reset();
    for (brush::PenSample& sample : begun.samples)
        sample.rotation_deg = turn.rotation_deg;
    painting.begun = std::move(begun);
    lay_samples(painting);
}

}  // namespace pastoso::document
