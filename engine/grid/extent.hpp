// Fields on a canvas that has been cut or made larger.
#pragma once

#include "grid/tiled_field.hpp"

#include <algorithm>

namespace pastoso::grid {

/// A canvas as a part of another one's plane.
struct Extent {
    Shape shape;
    int x0 = 0, y0 = 0;  ///< the other one's cell that becomes the cell (0, 0); may lie beside it

    bool is_tile_aligned() const { return x0 % kTileSize == 0 && y0 % kTileSize == 0; }
};

/// The part of put_on_extent() for single cells of a tile, `found` being theirs in `field`.
template <class Field>
void copy_cells(const Field& field, const Rect& found, const Extent& extent, int tile, Field& result) {
    const Shape& from = field.shape();
    const Rect tiles = from.tiles_touching(found);
    for (int row = tiles.y0; row < tiles.y1; ++row)
        for (int column = tiles.x0; column < tiles.x1; ++column) {
            const int source = row * from.tiles_x() + column;
            if (field.is_background(source)) continue;
            const auto values = field.read(source);
            auto* copy = result.write(tile);
            const Rect part = intersection(found, from.tile_cells(source));
            for (int y = part.y0; y < part.y1; ++y)
                for (int x = part.x0; x < part.x1; ++x)
                    copy[Shape::cell_in_tile(x - extent.x0, y - extent.y0)] =
                        values[Shape::cell_in_tile(x, y)];
        }
}

/// Puts the values of `field` into `result`, a field of the extent's shape that is background all over,
/// where the extent has them. Whole tiles that come onto tiles are shared. Either may be any field with
/// the members of TiledField.
template <class Field>
void put_on_extent(const Field& field, const Extent& extent, Field& result) {
    const Shape& from = field.shape();
    const Rect moved = intersection(from.cells(), {extent.x0, extent.y0, extent.x0 + extent.shape.width,
                                                   extent.y0 + extent.shape.height});
    for (int tile = 0; tile < result.tile_count(); ++tile) {
        Rect cells = extent.shape.tile_cells(tile);
        cells = {cells.x0 + extent.x0, cells.y0 + extent.y0, cells.x1 + extent.x0, cells.y1 + extent.y0};
        const Rect found = intersection(cells, moved);
        if (found.empty()) continue;
        const int source = from.tile_at(found.x0, found.y0);
        if (extent.is_tile_aligned() && found.width() == kTileSize && found.height() == kTileSize) {
            if (!field.is_background(source)) result.replace(tile, field.block(source));
            continue;
        }
        copy_cells(field, found, extent, tile, result);
    }
}

}  // namespace pastoso::grid
