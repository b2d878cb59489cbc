#include "document/actions/adjust_actions.hpp"

#include "core/error.hpp"
#include "document/living_painting.hpp"
#include "document/paint_mixing.hpp"

namespace pastoso::document {

void check_whole(const AdjustDryPaint& adjust) {
    check_paint(adjust.paint);
}

void check_possible(const AdjustDryPaint& adjust, const LivingPainting& painting) {
    check_paintable(painting.value.layers, painting.value.layers.active);
    if (!layers::can_lie_dry(mixed_paint(adjust.paint, painting.medium)))
        throw core::InputError("the medium in hand leaves next to nothing when it dries.");
}

UndoStep undo_step(const AdjustDryPaint&, const LivingPainting& painting) {
    return {.name = Table<AdjustDryPaint>::kTraits.step, .layer = painting.active_layer().look.name};
}

void apply(const AdjustDryPaint& adjust, LivingPainting& painting) {
    const AdjustedPaint paint = painting.canvas.adjust_dry(mixed_paint(adjust.paint, painting.medium),
                                                           adjust.way, painting.unmasked().get());
    painting.value.flows.taken += painting.contents_of(paint.taken);
    painting.value.flows.wiped += painting.contents_of(paint.wiped);
}

}  // namespace pastoso::document
