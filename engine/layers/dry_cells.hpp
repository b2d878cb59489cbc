// The cells of a layer that hold dry paint.
#pragma once

#include "film/state.hpp"
#include "grid/mask.hpp"
#include "layers/apart.hpp"

#include <cstdint>

namespace pastoso::layers {

/// Calls visit(cell, share) for those of a tile that are chosen, row by row, and by how much
/// (grid::Mask); null: all are, as a whole. The layer is apart from what it lies on.
template <class Visit>
void for_each_dry_cell(const film::FilmState& layer, const grid::Mask* where, int tile, Visit&& visit) {
    if (!holds_dry_paint(layer, tile)) return;
    const grid::Rect cells = layer.shape.tile_cells(tile);
    for (int y = cells.y0; y < cells.y1; ++y)
        for (int x = cells.x0; x < cells.x1; ++x) {
            const std::uint8_t share = where != nullptr ? where->at(x, y) : grid::kWhole;
            if (share != 0 && holds_dry_paint(layer, x, y))
                visit(grid::Shape::cell_in_tile(x, y), share);
        }
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
