// The cells of a layer that hold dry paint.
#pragma once

#include "film/state.hpp"
#include "grid/mask.hpp"
#include "layers/apart.hpp"

#include <cstdint>

namespace pastoso::layers {

/// Calls visit(cell) for those of a tile that are in the mask, row by row; null: all are. The layer is
/// apart from what it lies on.
template <class Visit>
void for_each_dry_cell(const film::FilmState& layer, const grid::Mask* where, int tile, Visit&& visit) {
    if (!holds_dry_paint(layer, tile)) return;
    const grid::Rect cells = layer.shape.tile_cells(tile);
    for (int y = cells.y0; y < cells.y1; ++y)
        for (int x = cells.x0; x < cells.x1; ++x)
            if ((where == nullptr || where->at(x, y) != 0) && holds_dry_paint(layer, x, y))
                visit(grid::Shape::cell_in_tile(x, y));
}

/// Whether there is one on the layer.
bool any_dry_cell(const film::FilmState& layer);

/// How many there are in all.
std::int64_t dry_cell_count(const film::FilmState& layer, const grid::Mask* where);

/// Dry cells of a layer, picked evenly, as a layer of one tile of their own, row by row.
struct DrySample {
    film::FilmState film;
    int count = 0;  ///< at most grid::kTileCells; the others are bare
};
DrySample dry_sample(const film::FilmState& layer, const grid::Mask* where);

}  // namespace pastoso::layers
