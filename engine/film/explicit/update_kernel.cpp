// Compiled once per instruction set, whose registers the compiler fills by itself; see
// pastoso_add_kernels.
#include "film/explicit/tile_kernels.hpp"

namespace pastoso::film::PASTOSO_ISA {

using grid::kTileSize;

void apply_fluxes(const TileScratch& scratch, std::int32_t* after) {
    for (int y = 0; y < kTileSize; ++y) {
        const std::int32_t* before = &scratch.block.quanta[block_index(0, y)];
        const std::int32_t* flux_x = &scratch.flux_x[face_index(0, y)];
        const std::int32_t* flux_y = &scratch.flux_y[face_index(0, y)];
        std::int32_t* row = after + y * kTileSize;
        for (int x = 0; x < kTileSize; ++x)
            row[x] = before[x] + (flux_x[x - 1] - flux_x[x]) + (flux_y[x - kFaceStride] - flux_y[x]);
    }
}

void largest_changes(const std::int32_t* before, const std::int32_t* after, int first_row, int last_row,
                     ColumnChanges& changes) {
    changes.fill(0);
    for (int y = first_row; y < last_row; ++y)
        for (int x = 0; x < kTileSize; ++x) {
            const std::int32_t difference = after[y * kTileSize + x] - before[y * kTileSize + x];
            const std::int32_t change = difference < 0 ? -difference : difference;
            changes[x] = changes[x] > change ? changes[x] : change;
        }
}

}  // namespace pastoso::film::PASTOSO_ISA
