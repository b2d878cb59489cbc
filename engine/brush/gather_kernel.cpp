// Compiled once per instruction set; see pastoso_add_kernels.
#include "brush/gather_kernel.hpp"

#include "core/lane_memory.hpp"
#include "grid/shape.hpp"

namespace pastoso::brush::PASTOSO_ISA {
namespace {

namespace lanes = core::lanes;

using Floats = lanes::Widest<float>;
using Ints = lanes::As<std::int32_t, Floats>;

PASTOSO_LANE_FUNCTION int whole_below(double x) {
    const int truncated = static_cast<int>(x);
    return truncated - (truncated > x ? 1 : 0);
}

/// A piece of a row within one tile.
struct Row {
    int cell;  ///< index of the first in the tile
    int count;
    float x_mm, y_mm;  ///< centre of the first, from the middle of the footprint
};

/// Begins a pass over those cells within the row that are in none, and writes what was found.
template <class F, class I, class Inside>
PASTOSO_LANE_FUNCTION void find(const PassTile& pass, int cell, I quanta, Inside inside,
                                std::int32_t* found_column) {
    const auto begun = lanes::load_where<F>(pass.begun_mm + cell, inside);
    const auto before = lanes::load_where<I>(pass.found + cell, inside);
    const auto anew = begun < F(pass.expired_mm) && inside;
    if (!lanes::may_have_any(anew)) return lanes::store(found_column, before);
    const I found = lanes::select(anew, quanta, before);
    lanes::store_where(pass.begun_mm + cell, lanes::select(anew, F(pass.travel_mm), begun), anew);
    lanes::store_where(pass.found + cell, found, anew);
    lanes::store(found_column, found);
}

/// How a tile's support is stored.
struct InFloats {
    const float* heights_mm;
    template <class F>
    PASTOSO_LANE_MEMBER F at(int cell) const {
        return lanes::load<F>(heights_mm + cell);
    }
};
struct InLevels {
    const std::uint16_t* levels;
    float level_mm;
    template <class F>
    PASTOSO_LANE_MEMBER F at(int cell) const {
        const auto level = lanes::load<lanes::As<std::uint16_t, F>>(levels + cell);
        return lanes::convert<float>(lanes::convert<std::int32_t>(level)) * level_mm;
    }
};

/// Gathers cell `i` of a row, or as many from there on as F and I hold. Thickness and pass beyond the
/// row's end are neither read nor written where registers have masks: another thread may change them.
template <class F, class I, class Support>
PASTOSO_LANE_FUNCTION void gather_cells(const GatherSource& tile, const Support& support, const Row& row,
                                        int i, float cell_mm, const GatherColumns& to) {
    const I number = lanes::counting<I>() + i;
    const auto inside = number < I(row.count);
    const auto quanta = lanes::load_where<I>(tile.thickness + row.cell + i, inside);
    lanes::store(to.thickness + i, quanta);
    lanes::store(to.support_mm + i, support.template at<F>(row.cell + i));
    lanes::store(to.dx_mm + i, row.x_mm + lanes::convert<float>(number) * cell_mm);
    lanes::store(to.dy_mm + i, F(row.y_mm));
    lanes::store(to.cell + i, number + row.cell);
    if (tile.pass.found != nullptr)
        find<F>(tile.pass, row.cell + i, quanta, inside, to.found + i);
    else
        lanes::store(to.found + i, quanta);
}

/// From this width on the exchange, which will want the paint of these cells soon, finds it in memory;
/// smaller footprints mostly touch cells that others have just touched.
constexpr int kWideRow = 9;

/// In whole registers, as long as they do not reach beyond the tile (without masks: beyond the row);
/// what is too much in the columns is overwritten by the next row.
template <class Support>
PASTOSO_LANE_FUNCTION void gather_row(const GatherSource& tile, const Support& support, const Row& row,
                                      float cell_mm, const GatherColumns& to) {
    constexpr int kLanes = Floats::kLanes;
    const int end = lanes::kMasked ? grid::kTileCells : row.cell + row.count;
    int i = 0;
    for (; i < row.count && row.cell + i + kLanes <= end; i += kLanes)
        gather_cells<Floats, Ints>(tile, support, row, i, cell_mm, to);
    for (; i < row.count; ++i)
        gather_cells<float, std::int32_t>(tile, support, row, i, cell_mm, to);
    if (row.count < kWideRow) return;
    for (int cell = row.cell; cell < row.cell + row.count; ++cell)
        __builtin_prefetch(&tile.paint[cell], 1);
}

/// Rows are outlined so many at a time, whole registers of them.
constexpr int kRowStep = 8;

/// The parts of rows that lie within a disc; count <= 0: none.
struct Rows {
    int cell[kRowStep], count[kRowStep];
    float x_mm[kRowStep], y_mm[kRowStep];

    PASTOSO_LANE_MEMBER Row operator[](int i) const { return {cell[i], count[i], x_mm[i], y_mm[i]}; }
};

PASTOSO_LANE_FUNCTION void outline(const Disc& disc, const grid::Rect& part, int y, double cell_mm,
                                   Rows& rows) {
    for (int i = 0; i < kRowStep; ++i) {
        const double off = y + i - disc.y;
        const double within = disc.radius * disc.radius - off * off;
        const double half = __builtin_sqrt(within > 0.0 ? within : 0.0);
        const int first = lanes::max(part.x0, -whole_below(half - disc.x));
        const int end = lanes::min(part.x1, whole_below(disc.x + half) + 1);
        rows.cell[i] = (y + i) % grid::kTileSize * grid::kTileSize + first % grid::kTileSize;
        rows.count[i] = end - first;
        rows.x_mm[i] = static_cast<float>((first - disc.x) * cell_mm);
        rows.y_mm[i] = static_cast<float>(off * cell_mm);
    }
}

template <class Support>
PASTOSO_LANE_FUNCTION int gather_part(const GatherSource& tile, const Support& support,
                                      const grid::Rect& part, const Disc& disc, double cell_mm,
                                      GatherColumns to) {
    int gathered = 0;
    Rows rows;
    for (int y = part.y0; y < part.y1; ++y) {
        const int i = (y - part.y0) % kRowStep;
        if (i == 0) outline(disc, part, y, cell_mm, rows);
        const Row row = rows[i];
        if (row.count <= 0) continue;
        gather_row(tile, support, row, static_cast<float>(cell_mm),
                   {to.dx_mm + gathered, to.dy_mm + gathered, to.support_mm + gathered,
                    to.thickness + gathered, to.found + gathered, to.cell + gathered});
        gathered += row.count;
    }
    return gathered;
}

}  // namespace

int gather(const GatherSource& tile, const grid::Rect& part, const Disc& disc, double cell_mm,
           GatherColumns to) {
    if (tile.support.levels != nullptr)
        return gather_part(tile, InLevels{tile.support.levels, tile.support.level_mm}, part, disc,
                           cell_mm, to);
    return gather_part(tile, InFloats{tile.support.heights_mm}, part, disc, cell_mm, to);
}

}  // namespace pastoso::brush::PASTOSO_ISA

PASTOSO_REGISTER_KERNELS(pastoso::brush, GatherKernels, gather)
