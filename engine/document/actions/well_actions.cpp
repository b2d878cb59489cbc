#include "document/actions/well_actions.hpp"

#include "document/living_painting.hpp"
#include "document/paint_mixing.hpp"

namespace pastoso::document {

void check_whole(const SqueezePaint& squeeze) {
    check_paint(squeeze.paint);
}

bool changes_anything(const CleanWell&, const LivingPainting& painting) {
    return painting.value.well.has_value();
}

void apply(const SqueezePaint& squeeze, LivingPainting& painting) {
    const film::PaintCoefficients paint = mixed_paint(squeeze.paint, painting.medium);
    film::Solver& solver = painting.used_well();
    painting.value.flows.taken += squeeze_onto(*painting.value.well, solver, painting.medium, paint,
                                               squeeze.volume_mm3, squeeze.x_mm, squeeze.y_mm);
}

void apply(const CleanWell&, LivingPainting& painting) {
    painting.value.flows.wiped += painting.paint_in_well();
    painting.well_solver.reset();
    painting.value.well.reset();
}

}  // namespace pastoso::document
