#include "film/explicit/concentration_block.hpp"

#include <algorithm>

namespace pastoso::film {
namespace {

using grid::kTileSize;

std::int32_t gather_row(const FilmState& state, const HaloMap& columns, const HaloSource& row,
                        int tile_x, Concentrate concentrate, float* out) {
    const int first_tile = row.tile * state.shape.tiles_x();
    std::int32_t largest = 0;
    const auto one_cell = [&](int x) {
        const HaloSource& column = columns.cells[x + kHalo];
        float* cell_out = out + x * kPaintChannels;
        if (column.outside) {
            std::fill_n(cell_out, kPaintChannels, 0.0F);
            return;
        }
        const int tile = first_tile + column.tile;
        const int cell = row.cell * kTileSize + column.cell;
        largest = std::max(largest, concentrate(state.paint.read(tile) + cell,
                                                state.thickness.read(tile) + cell, 1, cell_out));
    };
    const int tile = first_tile + tile_x;
    const int first_cell = row.cell * kTileSize;
    largest = concentrate(state.paint.read(tile) + first_cell, state.thickness.read(tile) + first_cell,
                          columns.extent, out);
    for (int x = -kConcentrationHalo; x < 0; ++x)
        one_cell(x);
    for (int x = columns.extent; x < columns.extent + kConcentrationHalo; ++x)
        one_cell(x);
    return largest;
}

}  // namespace

std::int32_t gather_concentrations(const FilmState& state, const HaloMap& columns, const HaloMap& rows,
                                   int tile_x, Concentrate concentrate, float* out) {
    std::int32_t largest = 0;
    for (int y = -kConcentrationHalo; y < rows.extent + kConcentrationHalo; ++y) {
        const HaloSource& row = rows.cells[y + kHalo];
        if (row.outside)
            std::fill_n(out + concentration_index(-kConcentrationHalo, y),
                        kConcentrationSide * kPaintChannels, 0.0F);
        else
            largest = std::max(largest, gather_row(state, columns, row, tile_x, concentrate,
                                                   out + concentration_index(0, y)));
    }
    return largest;
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
