#include "film/explicit/concentration_block.hpp"

#include "film/explicit/halo_runs.hpp"

#include <algorithm>

namespace pastoso::film {
namespace {

using grid::kTileSize;

/// Fills what is meant for neighbouring cells of the tile, from number `first` on, at (x, y).
void concentrate(const FilmState& state, int tile, int first, int count, int x, int y,
                 Concentrations& out) {
    const auto& kernels = core::kernels<TileKernels>();
    const PaintCell* paint = state.paint.read(tile) + first;
    const std::int32_t* thickness = state.thickness.read(tile) + first;
    const int index = concentration_index(x, y);
    if (out.upper == nullptr) {
        out.largest =
            std::max(out.largest, kernels.concentrate(paint, thickness, count, out.lower + index));
        return;
    }
    const WetStrataCells cells{paint, thickness, state.lower.paint.read(tile) + first,
                               state.lower.thickness.read(tile) + first};
    const std::uint8_t* read = out.read->data() + concentration_place(x, y);
    out.largest = std::max(out.largest, kernels.concentrate_strata(cells, read, count, out.lower + index,
                                                                   out.upper + index));
}

void clear(int index, int count, Concentrations& out) {
    std::fill_n(out.lower + index, count * kPaintChannels, 0.0F);
    if (out.upper != nullptr) std::fill_n(out.upper + index, count * kPaintChannels, 0.0F);
}

void gather_row(const FilmState& state, const HaloMap& columns, const HaloSource& row, int y, int tile_x,
                Concentrations& out) {
    for_each_run(
        state.shape.tiles_x(), columns, row, tile_x, kConcentrationHalo,
        [&](int tile, int cell, int x, int count) { concentrate(state, tile, cell, count, x, y, out); },
        [&](int x) { clear(concentration_index(x, y), 1, out); });
}

}  // namespace

void gather_concentrations(const FilmState& state, const HaloMap& columns, const HaloMap& rows,
                           int tile_x, Concentrations& out) {
    for (int y = -kConcentrationHalo; y < rows.extent + kConcentrationHalo; ++y) {
        const HaloSource& row = rows.cells[y + kHalo];
        if (row.outside)
            clear(concentration_index(-kConcentrationHalo, y), kConcentrationSide, out);
        else
            gather_row(state, columns, row, y, tile_x, out);
    }
}

void gather_held(const FilmState& state, const HaloMap& columns, const HaloMap& rows,
                 std::vector<PaintCell>& held) {
    held.assign(kHeldSide * kHeldSide, {});
    for (int y = -1; y <= rows.extent; ++y)
        for (int x = -1; x <= columns.extent; ++x) {
            const HaloSource& row = rows.cells[y + kHalo];
            const HaloSource& column = columns.cells[x + kHalo];
            if (row.outside || column.outside) continue;
            const int tile = row.tile * state.shape.tiles_x() + column.tile;
            held[held_index(x, y)] = state.paint.read(tile)[row.cell * kTileSize + column.cell];
        }
}

}  // namespace pastoso::film
