// A tile with a wide margin, seen through the tiles that hold its cells: where each row and column of
// such a window comes from, and copying tile arrays into it.
#pragma once

#include "film/solver.hpp"
#include "grid/shape.hpp"

#include <algorithm>
#include <vector>

namespace pastoso::film {

/// Consecutive positions along one axis of a window that come from consecutive cells of one tile.
struct WindowRun {
    int position = 0;  ///< of the first cell, relative to the window's first
    int count = 0;
    int tile = 0;  ///< tile column or row
    int cell = 0;  ///< within that tile
};

/// The runs that cover cells [first - margin, first + kTileSize + margin) of a tile's axis. Positions
/// beyond a canvas edge that is not periodic belong to no run.
std::vector<WindowRun> window_runs(int tile_index, int canvas_cells, Edge edge, int margin);

/// The other way round: the stretches of a tile's cells that the windows of this and other tiles cover,
/// `tile` being the window's and `cell` of the given tile.
std::vector<WindowRun> covering_runs(int tile_index, int canvas_cells, Edge edge, int margin);

/// Copies a run of values; those of a whole tile's row without asking how many.
template <class T>
void copy_run(const T* from, int count, T* to) {
    if (count == grid::kTileSize)
        std::copy_n(from, grid::kTileSize, to);
    else
        for (int k = 0; k < count; ++k)
            to[k] = from[k];
}

/// Whether the runs leave no position of a window out.
inline bool cover_all(const std::vector<WindowRun>& runs, int size) {
    int covered = 0;
    for (const WindowRun& run : runs)
        covered += run.count;
    return covered == size;
}

/// Copies cells into the window `out` (rows of `stride`, its first value that of the window's first
/// cell). `row_of(tile_x, tile_y, cell_y)` gives the values of a row of a tile's cells, or null for a
/// tile that takes no part: its cells, and those of no tile, are set to zero. `size` is the window's
/// width and height.
template <class RowOf, class T>
void gather_window(const std::vector<WindowRun>& columns, const std::vector<WindowRun>& rows, int size,
                   int stride, const RowOf& row_of, T* out) {
    if (!cover_all(columns, size) || !cover_all(rows, size))
        for (int y = 0; y < size; ++y)
            std::fill_n(out + y * stride, size, T{});
    for (const WindowRun& row : rows)
        for (const WindowRun& column : columns)
            for (int k = 0; k < row.count; ++k) {
                const T* source = row_of(column.tile, row.tile, row.cell + k);
                T* to = out + (row.position + k) * stride + column.position;
                if (source == nullptr)
                    std::fill_n(to, column.count, T{});
                else
                    copy_run(source + column.cell, column.count, to);
            }
}

}  // namespace pastoso::film
