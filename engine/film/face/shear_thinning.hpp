// Paint that flows the easier the faster it is sheared: Herschel and Bulkley's law,
//     tau = tau_y + K gamma^n,   0.2 <= n <= 1.
#pragma once

#include "core/lane_power.hpp"
#include "film/step_constants.hpp"

namespace pastoso::film {

namespace lanes = core::lanes;

/// The viscosity of a film of mean velocity `speed` that makes Bingham's (or Newton's) film law give
/// that of Herschel and Bulkley, over the viscosity K at a shear rate of 1/s:
///     gamma^(n-1) (n+1)/n (1/2 - e/6) / (1 - q e),   q = n / (2n + 1),
/// where e = K gamma^n / (tau_y + K gamma^n) is the sheared share of the film and gamma the shear rate
/// at the wall, from |u| = h gamma n/(n+1) e (1 - q e). Without a yield stress e = 1. With one, gamma
/// comes from Newton steps in its logarithm; `against_yield` is K / tau_y.
template <bool kYield, class F>
PASTOSO_LANE_FUNCTION F relative_viscosity(F speed, F thickness, F against_yield, F flow_index) {
    const F one(1.0F), tiny(1e-30F);
    const F n = flow_index, q = n / (F(2.0F) * n + one), share = (n + one) / n;
    const F slowest = lanes::log2(F(kSlowestShear)), fastest = lanes::log2(F(kFastestShear));
    const F whole_film = lanes::log2(F(speed / (thickness + F(1e-12F)) * share + tiny));
    F sheared = one;
    F rate = lanes::clamp(F(whole_film - lanes::log2(F(one - q))), slowest, fastest);
    if constexpr (kYield) {
        for (int iteration = 0; iteration < 4; ++iteration) {
            const F stress = against_yield * lanes::exp2(F(n * rate));
            sheared = stress / (one + stress);
            const F wanted = whole_film - lanes::log2(F(sheared * (one - q * sheared) + tiny));
            rate =
                lanes::clamp(F(rate + (wanted - rate) / (one + n * (one - sheared))), slowest, fastest);
        }
    }
    const F profile = share * (F(0.5F) - sheared * F(1.0F / 6.0F)) / (one - q * sheared);
    return profile * lanes::exp2(F((n - one) * rate));
}

}  // namespace pastoso::film
