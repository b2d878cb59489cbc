// The motion of bristles, compiled for every instruction set (pastoso_add_kernels).
#pragma once

#include "core/kernels.hpp"

#include <cstdint>

namespace pastoso::brush {

/// What the whole tip has in common during one step.
struct StepFlex {
    double length_mm, full_depth_mm, per_full_depth, bend, splay, tilt_gain;
    double stiff_end_mm;  ///< > 0
    double restore;       ///< share of the way back to rest in this step
};

/// The hand during one step (hand_pose.hpp).
struct FerrulePose {
    double x_mm, y_mm, press, lean_x, lean_y, cos_rotation, sin_rotation;
};

/// Some bristles of a tip, a column for each number of theirs. All columns are worked on; those beyond
/// the last bristle may hold any finite numbers.
struct MotionColumns {
    static constexpr int kCount = 16;
    using Column = double[kCount];

    alignas(64) Column root_x_mm, root_y_mm, per_distance, deficit_mm, stiffness;
    alignas(64) Column was_down;    ///< 1 for those that touch the canvas already, 0
    alignas(64) Column x_mm, y_mm;  ///< of the tips, before and after
    alignas(64) Column depth_mm;    ///< how far the hair is pressed down, touching if > 0
    alignas(64) Column press;       ///< 0 to 1, where it touches
};

/// Cells of the canvas from its cell size and the size of the tufts.
struct TuftGrid {
    double cells_per_mm, tuft_cells, last_column, last_row;
};

/// The cells below the middles and the ends of the tufts, the nearest ones beyond the edges.
struct TuftCells {
    using Column = std::int32_t[MotionColumns::kCount];
    alignas(64) Column x, y, left, right, above, below;
};

struct MotionKernels {
    /// Moves the bristles by one step; bristle_motion.hpp says how.
    void (*move)(const StepFlex&, const FerrulePose&, MotionColumns&);
    void (*compute_tufts)(const TuftGrid&, const MotionColumns&, TuftCells&);

    static const MotionKernels baseline, avx2, avx512;
};

}  // namespace pastoso::brush
