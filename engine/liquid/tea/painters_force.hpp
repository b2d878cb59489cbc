// What the painter stirs the tea with: a swirl around an upright axis, and a push down along it.
#pragma once

#include "core/thread_pool.hpp"
#include "liquid/flow/velocity.hpp"
#include "liquid/tea/tea_settings.hpp"

namespace pastoso::liquid {

/// Adds over `dt_s` an acceleration
///     (swirl e_z x r - push e_z) exp(-r^2 / (2 reach^2)),   r from the axis.
/// It has to fade: the pressure of a closed vessel takes up all that is alike everywhere, so that a push
/// would do nothing, and a swirl the same wherever its axis stands.
void add_painters_force(const TeaSettings& settings, float dt_s, VelocityField& velocity,
                        core::ThreadPool& pool);

}  // namespace pastoso::liquid
