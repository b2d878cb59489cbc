#include "film/explicit/rheology_block.hpp"

#include "film/explicit/halo_runs.hpp"

#include <algorithm>

namespace pastoso::film {
namespace {

using grid::kTileSize;

/// Cells of margin: a face looks at the cells beside it.
constexpr int kMargin = 1;

struct Sources {
    const FilmState& state;
    const HaloMap& columns;
    int tile_x;
    float yield_per_Pa;
    CellRheology rheology;
};

void clear(HaloBlock& block, int first, int count) {
    std::fill_n(&block.viscosity[first], count, static_cast<float>(kThinnest_m2_s * 1e6));
    std::fill_n(&block.yield[first], count, 0.0F);
}

void gather_row(const Sources& from, const HaloSource& row, int y, HaloBlock& block) {
    for_each_run(from.state.shape.tiles_x(), from.columns, row, from.tile_x, kMargin,
                 [&](int tile, int cell, int x, int count) {
                     const int i = block_index(x, y);
                     from.rheology(from.state.paint.read(tile) + cell,
                                   from.state.thickness.read(tile) + cell, count, from.yield_per_Pa,
                                   &block.viscosity[i], &block.yield[i]);
                 });
}

}  // namespace

void gather_rheology(const FilmState& state, const HaloMap& columns, const HaloMap& rows, int tile_x,
                     float yield_per_Pa, CellRheology rheology, HaloBlock& block) {
    const Sources from{state, columns, tile_x, yield_per_Pa, rheology};
    for (int y = -kMargin; y < kTileSize + kMargin; ++y) {
        clear(block, block_index(-kHalo, y), kBlockStride);
        if (y >= rows.extent + kMargin) continue;
        const HaloSource& row = rows.cells[y + kHalo];
        if (!row.outside) gather_row(from, row, y, block);
    }
}

}  // namespace pastoso::film
