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
PASTOSO_LANE_FUNCTION void gather_cells(const GatherSource& tile, const Support& support,
                                        const GatherRow& row, int i, float cell_mm,
                                        const GatherColumns& to) {
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

/// In whole registers, as long as they do not reach beyond the tile (without masks: beyond the row);
/// what is too much in the columns is overwritten by the next row.
template <class Support>
PASTOSO_LANE_FUNCTION void gather_row(const GatherSource& tile, const Support& support,
                                      const GatherRow& row, float cell_mm, const GatherColumns& to) {
    constexpr int kLanes = Floats::kLanes;
    const int end = lanes::kMasked ? grid::kTileCells : row.cell + row.count;
    int i = 0;
    for (; i < row.count && row.cell + i + kLanes <= end; i += kLanes)
        gather_cells<Floats, Ints>(tile, support, row, i, cell_mm, to);
    for (; i < row.count; ++i)
        gather_cells<float, std::int32_t>(tile, support, row, i, cell_mm, to);
}

template <class Support>
PASTOSO_LANE_FUNCTION void gather_rows(const GatherSource& tile, const Support& support,
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
