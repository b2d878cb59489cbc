#include "film/explicit/numbers_block.hpp"

#include "film/explicit/halo_runs.hpp"
#include "film/step_setup.hpp"

#include <algorithm>
#include <vector>

namespace pastoso::film {
namespace {

/// Arrays to be filled, and the value of each medium for each.
struct NumberTable {
    std::vector<BlockArray<float>*> arrays;
    std::vector<std::vector<float>> media;

    void put(int medium, int first, int count) const {
        for (std::size_t n = 0; n < arrays.size(); ++n)
            std::fill_n(arrays[n]->data() + first, count, media[medium][n]);
    }
    /// The means over what a cell holds, by volume.
    void put_mixture(const MediaCell& foreign, int own, std::int32_t thickness, int i) const {
        const MediaCell amounts = all_media(foreign, own, thickness);
        if (amounts[own] == thickness) return put(own, i, 1);
        float whole = 0.0F;
        for (std::size_t k = 0; k < media.size(); ++k)
            whole += static_cast<float>(amounts[k]);
        for (std::size_t n = 0; n < arrays.size(); ++n) {
            float sum = 0.0F;
            for (std::size_t k = 0; k < media.size(); ++k)
                if (amounts[k] != 0) sum += static_cast<float>(amounts[k]) * media[k][n];
            (*arrays[n])[i] = sum / whole;
        }
    }
};

NumberTable table_of(const FilmState& state, CellNumbers<BlockArray<float>>& numbers) {
    NumberTable table{
        {&numbers.density_kg_m3, &numbers.tension, &numbers.flow_index, &numbers.drag_against,
         &numbers.drag_along, &numbers.slip_mm, &numbers.tan_advancing, &numbers.tan_receding},
        {}};
    for (const FilmNumbers& medium : state.media.numbers) {
        const CellNumbers<float> cell = cell_numbers(medium, state.cell_mm);
        table.media.push_back({cell.density_kg_m3, cell.tension, cell.flow_index, cell.drag_against,
                               cell.drag_along, cell.slip_mm, cell.tan_advancing, cell.tan_receding});
    }
    return table;
}

void gather(const NumberTable& table, const FilmState& state, const HaloMap& columns,
            const HaloMap& rows, int tile_x) {
    table.put(0, 0, kBlockCells);
    for (int y = -kHalo; y < rows.extent + kHalo; ++y) {
        const HaloSource& row = rows.cells[y + kHalo];
        if (row.outside) continue;
        for_each_run(state.shape.tiles_x(), columns, row, tile_x, kHalo,
                     [&](int tile, int cell, int x, int count) {
                         const int own = state.media.own[tile], i = block_index(x, y);
                         if (!state.media.is_mixed(tile)) return table.put(own, i, count);
                         const MediaCell* foreign = state.media.foreign.read(tile) + cell;
                         const std::int32_t* thickness = state.thickness.read(tile) + cell;
                         for (int k = 0; k < count; ++k)
                             table.put_mixture(foreign[k], own, thickness[k], i + k);
                     });
    }
}

/// What a quantum of thickness that leaves a cell takes along of each medium but `own`: a hair less than
/// its share, so that rounding never overdraws the cell.
void concentrate(const MediaCell& foreign, int its_own, std::int32_t thickness, int own, float* out) {
    constexpr float kShare = 1.0F - 0x1p-20F;
    std::fill_n(out, kMostMedia, 0.0F);
    if (thickness <= 0) return;
    MediaCell amounts = all_media(foreign, its_own, thickness);
    amounts[own] = 0;
    for (int k = 0; k < kMostMedia; ++k)
        out[k] =
            static_cast<float>(std::max(amounts[k] - 2, 0)) * (kShare / static_cast<float>(thickness));
}

}  // namespace

void gather_numbers(const FilmState& state, const HaloMap& columns, const HaloMap& rows, int tile_x,
                    HaloBlock& block) {
    gather(table_of(state, block.numbers), state, columns, rows, tile_x);
}

void gather_number(const FilmState& state, const HaloMap& columns, const HaloMap& rows, int tile_x,
                   double FilmNumbers::*number, float of_all, const StepConstants& step,
                   BlockArray<float>& out) {
    if (!step.media) return out.fill(of_all);
    NumberTable table{{&out}, {}};
    for (const FilmNumbers& medium : state.media.numbers)
        table.media.push_back({static_cast<float>(medium.*number)});
    gather(table, state, columns, rows, tile_x);
}

bool gather_media(const FilmState& state, const HaloMap& columns, const HaloMap& rows, int tile,
                  float* concentrations) {
    const int own = state.media.own[tile], tile_x = tile % state.shape.tiles_x();
    std::fill_n(concentrations, kConcentrationCount, 0.0F);
    bool any = false;
    for (int y = -kConcentrationHalo; y < rows.extent + kConcentrationHalo; ++y) {
        const HaloSource& row = rows.cells[y + kHalo];
        if (row.outside) continue;
        const auto concentrate_run = [&](int from, int cell, int x, int count) {
            const int its_own = state.media.own[from];
            if ((its_own == own && !state.media.is_mixed(from)) || state.thickness.is_background(from))
                return;
            any = true;
            for (int k = 0; k < count; ++k)
                concentrate(state.media.foreign.read(from)[cell + k], its_own,
                            state.thickness.read(from)[cell + k], own,
                            concentrations + concentration_index(x + k, y));
        };
        for_each_run(state.shape.tiles_x(), columns, row, tile_x, kConcentrationHalo, concentrate_run);
    }
    return any;
}

}  // namespace pastoso::film
