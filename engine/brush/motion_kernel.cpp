// Compiled once per instruction set; see pastoso_add_kernels.
#include "brush/motion_kernel.hpp"

#include "core/lanes.hpp"

namespace pastoso::brush::PASTOSO_ISA {
namespace {

namespace lanes = core::lanes;

/// Where a bent hair would rest: this share of its reach along the lean, and outward from the middle.
constexpr double kLeanRest = 0.6, kOutwardRest = 0.25;

PASTOSO_LANE_FUNCTION std::int32_t cell_at(double place_cells, double last) {
    return static_cast<std::int32_t>(lanes::min(lanes::max(place_cells, 0.0), last));
}

}  // namespace

void move(const StepFlex& flex, const FerrulePose& hand, MotionColumns& bristles) {
    for (int i = 0; i < MotionColumns::kCount; ++i) {
        const double place_x =
            bristles.root_x_mm[i] * hand.cos_rotation - bristles.root_y_mm[i] * hand.sin_rotation;
        const double place_y =
            bristles.root_x_mm[i] * hand.sin_rotation + bristles.root_y_mm[i] * hand.cos_rotation;
        const double lean_mm = place_x * hand.lean_x + place_y * hand.lean_y;
        const double depth_mm =
            hand.press * flex.full_depth_mm - bristles.deficit_mm[i] + flex.tilt_gain * lean_mm;
        const double press = lanes::min(depth_mm * flex.per_full_depth, 1.0) * bristles.stiffness[i];
        const double spread = 1.0 + flex.splay * press;
        const double root_x_mm = hand.x_mm + place_x * spread, root_y_mm = hand.y_mm + place_y * spread;
        const double outward = kOutwardRest * bristles.per_distance[i];
        const double rest_x = kLeanRest * hand.lean_x + outward * place_x;
        const double rest_y = kLeanRest * hand.lean_y + outward * place_y;
        const double bent_mm = lanes::max(depth_mm, 0.0);
        const double bent2_mm2 = bent_mm * bent_mm;
        const double reach_mm =
            flex.bend * bent2_mm2 / (bent2_mm2 + flex.stiff_end_mm * flex.stiff_end_mm) *
            __builtin_sqrt(lanes::max(bent_mm * (2.0 * flex.length_mm - bent_mm), 0.0));
        // The trailing offset after the root has moved, at most as long as the reach.
        const bool trails = bristles.was_down[i] > 0.0;
        double offset_x = trails ? bristles.x_mm[i] - root_x_mm : 0.0;
        double offset_y = trails ? bristles.y_mm[i] - root_y_mm : 0.0;
        offset_x += (rest_x * reach_mm - offset_x) * flex.restore;
        offset_y += (rest_y * reach_mm - offset_y) * flex.restore;
        const double length2 = offset_x * offset_x + offset_y * offset_y;
        const double taut = reach_mm / __builtin_sqrt(length2);
        const double share = length2 <= reach_mm * reach_mm ? 1.0 : taut;
        bristles.x_mm[i] = root_x_mm + offset_x * share;
        bristles.y_mm[i] = root_y_mm + offset_y * share;
        bristles.depth_mm[i] = depth_mm;
        bristles.press[i] = lanes::min(press, 1.0);
    }
}

void compute_tufts(const TuftGrid& grid, const MotionColumns& bristles, TuftCells& cells) {
    const double d = grid.tuft_cells;
    for (int i = 0; i < MotionColumns::kCount; ++i) {
        const double x = bristles.x_mm[i] * grid.cells_per_mm;
        cells.x[i] = cell_at(x, grid.last_column);
        cells.left[i] = cell_at(x - d, grid.last_column);
        cells.right[i] = cell_at(x + d, grid.last_column);
    }
    for (int i = 0; i < MotionColumns::kCount; ++i) {
        const double y = bristles.y_mm[i] * grid.cells_per_mm;
        cells.y[i] = cell_at(y, grid.last_row);
        cells.above[i] = cell_at(y - d, grid.last_row);
        cells.below[i] = cell_at(y + d, grid.last_row);
    }
}

}  // namespace pastoso::brush::PASTOSO_ISA

PASTOSO_REGISTER_KERNELS(pastoso::brush, MotionKernels, move, compute_tufts)
