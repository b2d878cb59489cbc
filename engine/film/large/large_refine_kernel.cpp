// Newton's step for the drag law of a large step. Compiled once per instruction set; see
// pastoso_add_kernels.
#include "film/large/drag_answer.hpp"
#include "film/large/large_kernels.hpp"

namespace pastoso::film::PASTOSO_ISA {

using grid::kTileSize;

float refine_yielding(const StepConstants& step, const LargeScratch& large, LargeTile& tile) {
    float error = 0.0F;
    for (int y = -1; y < kTileSize; ++y) {
        const float* pressure = &large.pressure[window_index(0, y)];
        const std::int32_t* quanta = &large.thickness[window_index(0, y)];
        const PressureRow along_y{pressure, quanta, kWindowStride, 1};
        error = lanes::max(error, answer_row<true, true>(step, along_y, 0, y, tile.y));
        if (y < 0) continue;
        const PressureRow along_x{pressure, quanta, 1, kWindowStride};
        error = lanes::max(error, answer_row<true, true>(step, along_x, -1, y, tile.x));
    }
    compute_source(step, tile);
    return error;
}

}  // namespace pastoso::film::PASTOSO_ISA
