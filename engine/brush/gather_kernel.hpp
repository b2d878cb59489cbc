// Gathering the cells below a footprint, compiled for every instruction set (pastoso_add_kernels).
#pragma once

#include "core/kernels.hpp"
#include "core/lanes.hpp"
#include "film/cell/paint_cell.hpp"
#include "film/support/support_heights.hpp"
#include "grid/shape.hpp"

#include <cstdint>

namespace pastoso::brush {

/// In cells, from the centre of cell (0, 0).
struct Disc {
    double x, y, radius;
};

/// The entry of a found thickness once it is settled whether what comes in this pass buries what was
/// there: its complement, below 0. That of an entry is the one that was settled.
template <class Number>
PASTOSO_LANE_FUNCTION Number settled(Number found) {
    return -1 - found;
}

/// The thickness of an entry, settled or not.
template <class Number>
PASTOSO_LANE_FUNCTION Number found_thickness(Number entry) {
    return core::lanes::max(entry, settled(entry));
}

/// What a pass over the canvas knows of a tile (pass_map.hpp), null without a pass.
struct PassTile {
    float* begun_mm = nullptr;      ///< travel when the tip came
    std::int32_t* found = nullptr;  ///< thickness then, quanta, settled() or not
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

/// Columns of a CellBatch from the first cell on that is to be filled; there is room for kBatchStep
/// values too many.
struct GatherColumns {
    float *dx_mm, *dy_mm, *support_mm;
    std::int32_t *thickness, *found, *cell;
};

struct GatherKernels {
    /// Gathers those of a tile's cells whose centres lie within the disc, row by row, and begins a pass
    /// over those that are not being passed over. `part` of the canvas lies within the tile. Calls up
    /// the paint of wide rows as well. Returns how many cells they are.
    int (*gather)(const GatherSource& tile, const grid::Rect& part, const Disc& disc, double cell_mm,
                  GatherColumns to);

    static const GatherKernels baseline, avx2, avx512;
};

}  // namespace pastoso::brush
