// What happens to the paint in bristles, compiled for every instruction set (pastoso_add_kernels).
#pragma once

#include "brush/contents.hpp"
#include "brush/transfer_kernels.hpp"
#include "core/kernels.hpp"

#include <utility>

namespace pastoso::brush {

/// What a bristle may give in one step.
struct GivingLimits {
    double kept_share;  ///< of a channel that stays in any case
    double negligible;  ///< of which less than this is not given at all
    double strongest_per_mm;
};

struct ContentsKernels {
    /// Lets pairs of bristles exchange paint, one pair after the other (brush/wick.hpp), `wick` the
    /// share by which they do, 0 to 1.
    void (*wick)(Contents* held, const std::pair<int, int>* pairs, int count, double wick);
    /// The held paint as carried quanta per thickness quantum; the volume must not be 0.
    void (*give)(const Contents& held, const GivingLimits& limits, film::PaintCoefficients& given);
    /// Takes what the film gained.
    void (*take)(const ChangeSums& gained, double cell_area_mm2, Contents& held);

    static const ContentsKernels baseline, avx2, avx512;
};

}  // namespace pastoso::brush
