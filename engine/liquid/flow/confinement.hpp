// Vorticity confinement (Steinhoff and Underhill 1994, Fedkiw, Stam and Jensen 2001): a force
//     f = eps h (N x omega),   N = grad |omega| / |grad |omega||,
// that gives swirls back what the grid's own friction takes. More than 0.3 makes noise.
#pragma once

#include "core/thread_pool.hpp"
#include "liquid/flow/region.hpp"

namespace pastoso::liquid {

inline constexpr float kMostConfinement = 0.3F;

/// Adds dt f to the velocity on open faces. The velocity must be continued into the region.
void add_confinement(const Region& region, float strength, float dt_s, VelocityField& velocity,
                     core::ThreadPool& pool);

}  // namespace pastoso::liquid
