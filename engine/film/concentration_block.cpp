#include "film/concentration_block.hpp"

#include <algorithm>

namespace pastoso::film {
namespace {

using grid::kTileSize;

void gather_row(const FilmState& state, const HaloMap& columns, const HaloSource& row, int tile_x,
                Concentrate concentrate, float* out) {
    const int first_tile = row.tile * state.shape.tiles_x();
    const auto one_cell = [&](int x) {
        const HaloSource& column = columns.cells[x + kHalo];
        float* cell_out = out + x * kPaintChannels;
        if (column.outside) {
            std::fill_n(cell_out, kPaintChannels, 0.0F);
            return;
        }
        const int tile = first_tile + column.tile;
        const int cell = row.cell * kTileSize + column.cell;
        concentrate(state.paint.read(tile) + cell, state.thickness.read(tile) + cell, 1, cell_out);
    };
    const int tile = first_tile + tile_x;
    const int first_cell = row.cell * kTileSize;
    concentrate(state.paint.read(tile) + first_cell, state.thickness.read(tile) + first_cell,
                columns.extent, out);
    for (int x = -kConcentrationHalo; x < 0; ++x)
        one_cell(x);
    for (int x = columns.extent; x < columns.extent + kConcentrationHalo; ++x)
        one_cell(x);
}

}  // namespace

void gather_concentrations(const FilmState& state, const HaloMap& columns, const HaloMap& rows,
                           int tile_x, Concentrate concentrate, float* out) {
    for (int y = -kConcentrationHalo; y < rows.extent + kConcentrationHalo; ++y) {
        const HaloSource& row = rows.cells[y + kHalo];
        if (row.outside)
            std::fill_n(out + concentration_index(-kConcentrationHalo, y),
                        kConcentrationSide * kPaintChannels, 0.0F);
        else
            gather_row(state, columns, row, tile_x, concentrate, out + concentration_index(0, y));
    }
}

}  // namespace pastoso::film
