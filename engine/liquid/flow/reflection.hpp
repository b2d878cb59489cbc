// The middle of an advection-reflection step (Zehnder, Narain and Thomaszewski 2018).
#pragma once

#include "core/thread_pool.hpp"
#include "liquid/flow/velocity.hpp"

namespace pastoso::liquid {

/// velocity = 2 projected - velocity, at every sample, ghosts among them: what a projection took away is
/// taken away once more. Both have the same shape.
void reflect(VelocityField& velocity, const VelocityField& projected, core::ThreadPool& pool);

}  // namespace pastoso::liquid
