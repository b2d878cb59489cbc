// Copying rectangles of cells out of the tiles, with the edge cells repeated beyond the canvas.
#pragma once

#include "core/check.hpp"
#include "grid/shape.hpp"

#include <algorithm>
#include <cstddef>
#include <vector>

namespace pastoso::shade {

inline grid::Rect grown(const grid::Rect& cells, int by) {
    return {cells.x0 - by, cells.y0 - by, cells.x1 + by, cells.y1 + by};
}

/// The cells of the canvas that are nearest to those of a rectangle: the part on the canvas, or the
/// edge.
inline grid::Rect nearest_on_canvas(const grid::Shape& shape, const grid::Rect& cells) {
    PASTOSO_CHECK(!cells.empty());
    const int x0 = std::clamp(cells.x0, 0, shape.width - 1);
    const int y0 = std::clamp(cells.y0, 0, shape.height - 1);
    return {x0, y0, std::clamp(cells.x1, x0 + 1, shape.width),
            std::clamp(cells.y1, y0 + 1, shape.height)};
}

/// Gives every cell of a rectangle in `out` the value of the nearest cell of `source`, which holds those
/// of the rectangle `known`.
template <class T>
void copy_nearest(const std::vector<T>& source, const grid::Rect& known, const grid::Rect& cells, T* out,
                  std::ptrdiff_t stride) {
    for (int y = cells.y0; y < cells.y1; ++y) {
        const T* row = source.data() +
                       static_cast<std::ptrdiff_t>(std::clamp(y, known.y0, known.y1 - 1) - known.y0) *
                           known.width();
        for (int x = cells.x0; x < cells.x1; ++x) {
            out[(y - cells.y0) * stride + x - cells.x0] =
                row[std::clamp(x, known.x0, known.x1 - 1) - known.x0];
        }
    }
}

/// Sets the cells of a rectangle that may reach beyond the canvas: fill(part, target, stride) has to set
/// those of a rectangle on the canvas; the others get the value of the nearest.
template <class T, class Fill>
void fill_beyond_edges(const grid::Shape& shape, const grid::Rect& cells, T* out, int stride,
                       const Fill& fill) {
    const grid::Rect known = nearest_on_canvas(shape, cells);
    if (known == cells) {
        fill(known, out, stride);
        return;
    }
    std::vector<T> values(static_cast<std::size_t>(known.width()) * known.height());
    fill(known, values.data(), known.width());
    copy_nearest(values, known, cells, out, stride);
}

/// Calls copy(tile, cell, count, destination) for every stretch of cells of one row and one tile in a
/// rectangle on the canvas; `cell` is the index of the first within its tile.
template <class T, class Copy>
void gather_cells(const grid::Shape& shape, const grid::Rect& cells, T* out, std::ptrdiff_t stride,
                  const Copy& copy) {
    for (int y = cells.y0; y < cells.y1; ++y) {
        T* row = out + (y - cells.y0) * stride;
        for (int x = cells.x0; x < cells.x1;) {
            const int end = std::min(cells.x1, (x / grid::kTileSize + 1) * grid::kTileSize);
            copy(shape.tile_at(x, y), grid::Shape::cell_in_tile(x, y), end - x, row + (x - cells.x0));
            x = end;
        }
    }
}

}  // namespace pastoso::shade
