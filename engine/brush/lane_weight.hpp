// What one element of a row does across its lane, for kernels and for single numbers alike.
#pragma once

#include "core/lanes.hpp"

namespace pastoso::brush {

/// The integral of max(0, 1 - |x|) from 0 on.
template <class Number>
PASTOSO_LANE_FUNCTION Number lane_weight_up_to(Number x) {
    const Number within = core::lanes::max(core::lanes::min(x, Number(1.0F)), Number(-1.0F));
    return within - 0.5F * within * core::lanes::abs(within);
}

/// The weight max(0, 1 - |x| / core) of a lane as cells see it, s and `core` (above 0, below 1) in half
/// widths of what the lane reaches on cells: its mean over x from s - (1 - core) to s + (1 - core). Of
/// lanes whose middles lie `core` apart it has the sum 1 everywhere.
template <class Number>
PASTOSO_LANE_FUNCTION Number lane_weight(Number s, float core) {
    const float per_core = 1.0F / core, window = per_core - 1.0F;
    const Number x = s * per_core;
    return (lane_weight_up_to(x + window) - lane_weight_up_to(x - window)) * (0.5F / window);
}

/// The share of a gap that one of a row of elements closes which together close the share u: 1 - (1 -
/// u)^weight, whatever their order, so that their lanes leave no stripes. By the parabola through the
/// weights 0, 1/2 and 1, which grows with the weight up to u = 8/9; no more is closed.
template <class Number>
PASTOSO_LANE_FUNCTION Number lane_share(Number u, Number weight) {
    const Number left = core::lanes::max(core::lanes::sqrt(1.0F - u), Number(1.0F / 3.0F));
    const Number closed = 1.0F - left;
    return closed * weight * (3.0F - left - 2.0F * closed * weight);
}

}  // namespace pastoso::brush
