// Gathering the cells below a footprint, compiled for every instruction set (pastoso_add_kernels).
#pragma once

#include "core/kernels.hpp"
#include "film/cell/paint_cell.hpp"
#include "film/support/support_heights.hpp"

#include <cstdint>

namespace pastoso::brush {

/// In cells, from the centre of cell (0, 0).
struct Disc {
    double x, y, radius;
};

/// Cells [first, end) of a row of the canvas.
struct RowSpan {
    int first, end;
};

/// What a pass over the canvas knows of a tile (pass_map.hpp), null without a pass.
struct PassTile {
    float* begun_mm = nullptr;      ///< travel when the tip came
    std::int32_t* found = nullptr;  ///< thickness then, quanta
    float travel_mm = 0.0F;         ///< now
    float expired_mm = 0.0F;        ///< passes begun before are over
};

/// The values of one tile that are gathered.
struct GatherSource {
    const std::int32_t* thickness;
    film::TileHeights support;
    const film::PaintCell* paint;
    PassTile pass;
};

/// A piece of a row within one tile.
struct GatherRow {
    int cell;          ///< index of the first in the tile
    int count;         ///< at least 1
    float x_mm, y_mm;  ///< centre of the first, from the middle of the footprint
};

/// Columns of a CellBatch from the first cell on that is to be filled; there is room for kBatchStep
/// values too many.
struct GatherColumns {
    float *dx_mm, *dy_mm, *support_mm;
    std::int32_t *thickness, *found, *cell;
};

struct GatherKernels {
    /// The cells of the rows from `first_row` on whose centres lie within the disc.
    void (*outline)(const Disc& disc, int first_row, int rows, RowSpan* spans);
    /// Gathers rows of one tile, one after the other, and begins a pass over their cells that are not
    /// being passed over. Calls up the paint of the cells as well.
    void (*gather)(const GatherSource& tile, const GatherRow* rows, int row_count, float cell_mm,
                   GatherColumns to);

    static const GatherKernels baseline, avx2, avx512;
};

}  // namespace pastoso::brush
