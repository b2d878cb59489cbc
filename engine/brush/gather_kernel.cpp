// Compiled once per instruction set; see pastoso_add_kernels.
#include "brush/gather_kernel.hpp"

#include "brush/kernel_lanes.hpp"
#include "grid/shape.hpp"

namespace pastoso::brush::PASTOSO_ISA {
namespace {

PASTOSO_KERNEL_INLINE int whole_below(double x) {
    const int truncated = static_cast<int>(x);
    return truncated - (truncated > x ? 1 : 0);
}

/// Begins a pass over those cells within the row that are in none, and writes what was found.
template <class Floats, class Ints, class Inside>
PASTOSO_KERNEL_INLINE void find(const PassTile& pass, int cell, Ints quanta, Inside inside,
                                std::int32_t* found_column) {
    const auto begun = load_chosen<Floats>(pass.begun_mm + cell, inside);
    const auto before = load_chosen<Ints>(pass.found + cell, inside);
    const auto anew = (begun < pass.expired_mm) & inside;
    if (!may_have_any(anew)) return store(found_column, before);
    const Ints found = anew ? quanta : before;
    store_to_chosen(pass.begun_mm + cell, anew ? Floats{} + pass.travel_mm : begun, anew);
    store_to_chosen(pass.found + cell, found, anew);
    store(found_column, found);
}

/// How a tile's support is stored.
struct InFloats {
    const float* heights_mm;
    template <class Floats, class Shorts>
    PASTOSO_KERNEL_INLINE Floats at(int cell) const {
        return load<Floats>(heights_mm + cell);
    }
};
struct InLevels {
    const std::uint16_t* levels;
    float level_mm;
    template <class Floats, class Shorts>
    PASTOSO_KERNEL_INLINE Floats at(int cell) const {
        return as_floats(load<Shorts>(levels + cell)) * level_mm;
    }
};

/// Gathers cell `i` of a row, or as many from there on as a register holds. Thickness and pass beyond
/// the row's end are neither read nor written where registers have masks: another thread may change
/// them.
template <class Floats, class Ints, class Shorts, class Support>
PASTOSO_KERNEL_INLINE void gather_cells(const GatherSource& tile, const Support& support,
                                        const GatherRow& row, int i, float cell_mm,
                                        const GatherColumns& to) {
    const Ints number = load<Ints>(kCounting) + i;
    const auto inside = number < row.count;
    const auto quanta = load_chosen<Ints>(tile.thickness + row.cell + i, inside);
    store(to.thickness + i, quanta);
    store(to.support_mm + i, support.template at<Floats, Shorts>(row.cell + i));
    store(to.dx_mm + i, row.x_mm + as_floats(number) * cell_mm);
    store(to.dy_mm + i, Floats{} + row.y_mm);
    store(to.cell + i, number + row.cell);
    if (tile.pass.found != nullptr)
        find<Floats>(tile.pass, row.cell + i, quanta, inside, to.found + i);
    else
        store(to.found + i, quanta);
}

/// In whole registers, as long as they do not reach beyond the tile (without masks: beyond the row);
/// what is too much in the columns is overwritten by the next row.
template <class Support>
PASTOSO_KERNEL_INLINE void gather_row(const GatherSource& tile, const Support& support,
                                      const GatherRow& row, float cell_mm, const GatherColumns& to) {
    const int end = kMasked ? grid::kTileCells : row.cell + row.count;
    int i = 0;
    for (; i < row.count && row.cell + i + kLanes <= end; i += kLanes)
        gather_cells<FloatLanes, IntLanes, ShortLanes>(tile, support, row, i, cell_mm, to);
    for (; i < row.count; ++i)
        gather_cells<float, std::int32_t, std::uint16_t>(tile, support, row, i, cell_mm, to);
}

template <class Support>
PASTOSO_KERNEL_INLINE void gather_rows(const GatherSource& tile, const Support& support,
                                       const GatherRow* rows, int row_count, float cell_mm,
                                       GatherColumns to) {
    for (int r = 0; r < row_count; ++r) {
        const GatherRow& row = rows[r];
        gather_row(tile, support, row, cell_mm, to);
        // The exchange will want the paint of these cells soon.
        for (int i = 0; i < row.count; ++i)
            __builtin_prefetch(&tile.paint[row.cell + i], 1);
        to = {to.dx_mm + row.count,     to.dy_mm + row.count, to.support_mm + row.count,
              to.thickness + row.count, to.found + row.count, to.cell + row.count};
    }
}

}  // namespace

void outline(const Disc& disc, int first_row, int rows, RowSpan* spans) {
    for (int i = 0; i < rows; ++i) {
        const double off = first_row + i - disc.y;
        const double within = disc.radius * disc.radius - off * off;
        const double half = __builtin_sqrt(within > 0.0 ? within : 0.0);
        spans[i].first = -whole_below(half - disc.x);
        spans[i].end = whole_below(disc.x + half) + 1;
    }
}

void gather(const GatherSource& tile, const GatherRow* rows, int row_count, float cell_mm,
            GatherColumns to) {
    if (tile.support.levels != nullptr)
        gather_rows(tile, InLevels{tile.support.levels, tile.support.level_mm}, rows, row_count, cell_mm,
                    to);
    else
        gather_rows(tile, InFloats{tile.support.heights_mm}, rows, row_count, cell_mm, to);
}

}  // namespace pastoso::brush::PASTOSO_ISA

PASTOSO_REGISTER_KERNELS(pastoso::brush, GatherKernels, outline, gather)
