// What the drag law leaves of a velocity in a large step, and how that changes with it: shared by the
// kernels of one instruction set.
#pragma once

#include "film/face_physics.hpp"
#include "film/lane_groups.hpp"

namespace pastoso::film::PASTOSO_ISA {
namespace {

/// The flow u = F w that drag leaves of a velocity w along the axis, and du/dw. With s = 1 - 1/x^3 for
/// the wall shear x of Bingham's law (bingham_drag), the whole velocity's du/dw is s / (s + drag); of a
/// velocity that has a part across the axis, the part along it changes by that much only as far as it
/// lengthens the whole.
struct DragAnswer {
    Lanes flow, slope;
};
/// `drag` is lambda dt and `resistance` the wall stress, in yield stresses, of a unit of velocity.
template <bool kYield>
[[gnu::always_inline]] inline DragAnswer drag_answer(Lanes along, Lanes across, Lanes drag,
                                                     Lanes resistance) {
    const Lanes one(1.0F);
    if constexpr (kYield) {
        const Lanes along2 = along * along, size2 = along2 + across * across + Lanes(1e-30F);
        const BinghamDrag<Lanes> law = bingham_drag(drag, Lanes(lanes::sqrt(size2) * resistance));
        const Lanes whole = law.tangent_share / (law.tangent_share + drag + Lanes(1e-12F));
        return {Lanes(law.factor * along), Lanes(law.factor + (whole - law.factor) * along2 / size2)};
    }
    const Lanes factor = one / (one + drag);
    return {Lanes(factor * along), factor};
}

/// By what part the flux through a face differs from what its drag law wants. Fluxes of less than 1/50
/// cell a step count as that much.
[[gnu::always_inline, maybe_unused]] inline Lanes flux_error(Lanes wanted, Lanes flow, Lanes depth,
                                                             const StepConstants& step) {
    constexpr float kTraceFlux = 0.02F;
    const Lanes cells = depth * Lanes(step.dt_s * step.inverse_cell * step.inverse_cell);
    return lanes::abs(Lanes(wanted - flow)) * cells / (lanes::abs(flow) * cells + Lanes(kTraceFlux));
}

}  // namespace
}  // namespace pastoso::film::PASTOSO_ISA
