// Newton's step for the drag law of a large step. Compiled once per instruction set; see
// pastoso_add_kernels.
#include "film/drag_answer.hpp"
#include "film/large_kernels.hpp"

namespace pastoso::film::PASTOSO_ISA {
namespace {

using grid::kTileSize;

float refine_row(const StepConstants& step, const float* pressure, int along, int first_x, int y,
                 LargeFaces& faces) {
    const Lanes zero(0.0F), cell_per_step(step.cell_mm / step.dt_s);
    const Lanes dt_per_cell(step.dt_s * step.inverse_cell);
    const Lanes per_pressure = dt_per_cell * dt_per_cell;
    Lanes error(0.0F);
    for_each_lane_group(first_x, kTileSize, [&](int x) {
        const int f = face_index(x, y), i = window_index(x, y);
        const Lanes rise = load(pressure + i + along) - load(pressure + i);
        const Lanes depth = load(&faces.depth[f]), mobility = load(&faces.mobility[f]);
        const Lanes resistance = load(&faces.resistance[f]);
        const Lanes pushed = mobility * cell_per_step * rise / depth;
        const Lanes flow = load(&faces.star[f]) - lanes::select(depth > zero, pushed, zero);
        const Lanes driven = load(&faces.driven[f]);
        const Lanes velocity = driven - dt_per_cell * rise;
        const DragAnswer answer =
            drag_answer<true>(velocity, load(&faces.across[f]), load(&faces.drag[f]), resistance);
        const auto yields = resistance > zero;
        error =
            lanes::max(error, lanes::select(yields, flux_error(answer.flow, flow, depth, step), zero));
        const Lanes star = answer.flow - answer.slope * (velocity - driven);
        store(&faces.star[f], lanes::select(yields, star, load(&faces.star[f])));
        store(&faces.mobility[f],
              lanes::select(yields, Lanes(per_pressure * answer.slope * depth), mobility));
    });
    return lanes::stdx::hmax(error);
}

}  // namespace

float refine_yielding(const StepConstants& step, const LargeScratch& large, LargeTile& tile) {
    const float* pressure = large.pressure.data();
    float error = 0.0F;
    for (int y = -1; y < kTileSize; ++y) {
        error = lanes::max(error, refine_row(step, pressure, kWindowStride, 0, y, tile.y));
        if (y >= 0) error = lanes::max(error, refine_row(step, pressure, 1, -1, y, tile.x));
    }
    find_source(step, tile);
    return error;
}

}  // namespace pastoso::film::PASTOSO_ISA
