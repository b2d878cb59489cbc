// The inner loops of the paint exchange, compiled for every instruction set (pastoso_add_kernels); they
// see plain columns of numbers only. Every set gives the same bits: sums are sums of integers.
#pragma once

#include "core/kernels.hpp"
#include "film/cell/paint_cell.hpp"

#include <array>
#include <cstdint>

namespace pastoso::brush {

/// Columns of a CellBatch; `padded_count` is a multiple of kBatchStep.
struct BatchColumns {
    const float* dx_mm;
    const float* dy_mm;
    const std::int32_t* thickness;
    const std::int32_t* found;  ///< as PassTile has it
    const float* support_mm;
    std::int32_t* change;
    std::int32_t* swap;
    float* touched;  ///< how much of the exchange happens there in this step, 0 to 1
    int padded_count;
};

/// How one element of a tip acts on the cells below it (transfer.hpp has the equations).
struct ExchangeRule {
    /// Axes of the footprint, divided by its half sizes: s = dx across_x + dy across_y, t likewise.
    float across_x, across_y, along_x, along_y;
    bool lane;  ///< weight (1 - t^2)(1 + crown t^2), and across the lane that of lane_weight.hpp,
                ///< instead of (1 - r^2)(1 + crown r^2), r^2 = s^2 + t^2
    bool side_by_side;     ///< lanes overlap: what neighbours close together is lane_share()'s
    float lane_core;       ///< of a lane, below 1
    float crown;           ///< -1 to 1
    float cover;           ///< share of a cell that is covered, over the weight there; at most 1
    float underside_mm;    ///< height that the paint surface is driven to where the profile is 0
    float bearing_mm;      ///< height of what the element bears on
    float coat;  ///< 0: the surface is driven there, 1: a coat as thick as it is above the bearing
    float profile_mm;      ///< how much higher where the profile is 1
    const float* profile;  ///< from s = -1 to s = 1
    int segments;          ///< of the profile, between segments + 1 heights
    float lowest_mm;       ///< height down to which the hanging paint reaches
    float fade_per_mm;     ///< contact grows from 0 to 1 over the first 1 / fade_per_mm above it
    float rate;            ///< share of the gap closed in this step
    float pickup;          ///< share of that which is taken when paint is in the way
    float mix;             ///< equal-volume swap, share of the smaller layer
    float mix_depth_mm;    ///< the tool's own layer in that comparison
};

/// What the rule wants of a batch: sums over its cells, quanta.
struct WantedSums {
    std::int64_t deposit = 0;
    std::int64_t swap = 0;
    bool may_bury = true;  ///< paint may come onto enough of what a pass found for that to be buried
    bool changes = true;   ///< of some cell, paint is to be moved; false: of none
    bool touches = true;   ///< some cell is touched
};

/// Scales that keep a tool from giving more than it has, and the paint it gives.
struct ApplyRule {
    float deposit_scale = 1.0F;
    float swap_scale = 1.0F;
    float depth = 0.0F;  ///< how far down into two strata a touch takes from and stirs, 0 to 1
    film::PaintCoefficients given{};  ///< carried quanta per thickness quantum
    float hiding_quanta = 0.0F;       ///< thickness of it that hides what lies below; 0 without strata
    std::uint32_t dither_seed = 0;
};

/// What the cells of a batch gained, quanta.
struct ChangeSums {
    std::int64_t thickness = 0;
    std::array<std::int64_t, film::kPaintChannels> paint{};
    bool any = false;  ///< something changed, even if the sums are 0
};

/// One tile's cells of a batch, to be changed in `thickness` and `paint`; the columns can be read for
/// kBatchStep values more.
struct TileCells {
    std::int32_t* thickness;
    film::PaintCell* paint;
    std::int32_t* worked;  ///< the part of it that is; null where nobody follows it
    const std::int32_t* cell;
    const std::int32_t* held;   ///< thickness before, of each
    const std::int32_t* found;  ///< as PassTile has it, of each
    std::int32_t* pass_found;   ///< the pass's own, of the tile; null without a pass
    const std::int32_t* change;
    const std::int32_t* swap;
    const float* touched;
    int count;
};

/// The lower stratum of the same tile.
struct LowerCells {
    std::int32_t* thickness;
    film::PaintCell* paint;
};

struct TransferKernels {
    WantedSums (*plan)(const ExchangeRule&, const BatchColumns&);
    /// In a tile where every cell's paint is one.
    void (*apply)(const ApplyRule&, const TileCells&, ChangeSums&);
    /// Whether two strata begin in such a tile: other paint comes onto paint that was there. Settles the
    /// pass over the cells before, where it does not.
    bool (*meets_other)(const ApplyRule&, const film::PaintCell* paint, const TileCells&);
    void (*apply_strata)(const ApplyRule&, const TileCells&, const LowerCells&, ChangeSums&);

    static const TransferKernels baseline, avx2, avx512;
};

}  // namespace pastoso::brush
