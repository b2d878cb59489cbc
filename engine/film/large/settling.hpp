// Inertia of paint from one large step to the next.
#pragma once

#include "core/lanes.hpp"

namespace pastoso::film {

namespace lanes = core::lanes;

/// Paint is inertial below this drag (lambda dt); above it the old velocity is forgotten within a step.
inline constexpr float kInertialDrag = 10.0F;

/// The share that a velocity keeps where the thickness that it moves changes from one measure to
/// another: where that grows, it keeps its kinetic energy. It never gets faster, so that thin paint
/// which runs into thick comes to rest there, as in a hydraulic jump.
template <class F>
PASTOSO_LANE_FUNCTION F settled_share(F from, F to) {
    return lanes::min(F(1.0F), lanes::sqrt(F(from / (to + F(1e-30F)))));
}

}  // namespace pastoso::film
