// How a row of a block lies in tiles: for gathering what a tile's own cells and a few beside them hold.
#pragma once

#include "film/explicit/halo_block.hpp"

namespace pastoso::film {

/// Calls visit(tile, cell, x, count) for the runs of neighbouring cells that lie in one tile: those of
/// column `tile_x` itself, from x = 0, and single ones of `margin` columns on both sides. Of columns
/// beyond an open edge calls beyond(x) instead. The row is not beyond one.
template <class Visit, class Beyond>
void for_each_run(int tiles_x, const HaloMap& columns, const HaloSource& row, int tile_x, int margin,
                  const Visit& visit, const Beyond& beyond) {
    const int first_tile = row.tile * tiles_x, first_cell = row.cell * grid::kTileSize;
    visit(first_tile + tile_x, first_cell, 0, columns.extent);
    const auto beside = [&](int x) {
        const HaloSource& column = columns.cells[x + kHalo];
        if (column.outside)
            beyond(x);
        else
            visit(first_tile + column.tile, first_cell + column.cell, x, 1);
    };
    for (int x = -margin; x < 0; ++x)
        beside(x);
    for (int x = columns.extent; x < columns.extent + margin; ++x)
        beside(x);
}
template <class Visit>
void for_each_run(int tiles_x, const HaloMap& columns, const HaloSource& row, int tile_x, int margin,
                  const Visit& visit) {
    for_each_run(tiles_x, columns, row, tile_x, margin, visit, [](int) {});
}

}  // namespace pastoso::film
