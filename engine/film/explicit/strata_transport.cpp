#include "film/explicit/strata_transport.hpp"

#include "film/explicit/concentration_block.hpp"

#include <algorithm>
#include <limits>

namespace pastoso::film {
namespace {

constexpr std::int32_t kMostPigment = std::numeric_limits<std::int32_t>::max();

/// Where both strata may enter a cell, each gets half of what its channels can still count.
void halve_room(const BlockArray<std::int32_t>& upper_quanta, int columns, int rows,
                std::vector<PaintCell>& held) {
    for (int y = -1; y <= rows; ++y)
        for (int x = -1; x <= columns; ++x) {
            const int cell = block_index(x, y);
            const bool two = (upper_quanta[cell - 1] | upper_quanta[cell + 1] |
                              upper_quanta[cell - kBlockStride] | upper_quanta[cell + kBlockStride]) != 0;
            if (!two) continue;
            for (std::int32_t& channel : held[held_index(x, y)])
                channel += (kMostPigment - channel) / 2;
        }
}

}  // namespace

bool gather_strata(const FilmState& state, const TilePlace& place, const HaloBlock& block,
                   StrataScratch& upper) {
    const auto is_in = [&](int tile) { return state.lower.is_in(tile); };
    if (!any_tile_near(place, state.shape.tiles_x(), is_in)) return false;
    gather_quanta(state.lower.thickness, place.columns, place.rows, place.tile_x, upper.quanta);
    bool any = false;
    for (std::size_t i = 0; i < upper.quanta.size(); ++i) {
        const std::int32_t below = upper.quanta[i];
        upper.quanta[i] = below > 0 ? block.quanta[i] - below : 0;
        any = any || below > 0;
    }
    return any;
}

void move_strata(const FilmState& state, const TilePlace& place, const FilmProfile& profile,
                 WorkerScratch& worker, TileResult& result) {
    const int columns = place.columns.extent, rows = place.rows.extent;
    const auto& kernels = core::kernels<TileKernels>();
    TileScratch& scratch = worker.tile;
    StrataScratch& upper = *worker.strata;
    upper.concentrations.resize(kConcentrationCount);
    upper.changes.resize(grid::kTileCells);
    kernels.find_read_cells(scratch, columns, rows, upper);
    Concentrations concentrations{worker.concentrations.data(), upper.concentrations.data(),
                                  &upper.read};
    gather_concentrations(state, place.columns, place.rows, place.tile_x, concentrations);
    const bool crowded = concentrations.largest > kCrowded / 2;
    if (crowded) {
        gather_held(state, place.columns, place.rows, worker.held);
        halve_room(upper.quanta, columns, rows, worker.held);
    }
    kernels.split_strata(profile, static_cast<float>(state.cell_mm / kThicknessQuantum_mm), scratch,
                         upper);
    result.paint = new_paint(place);
    const StrataMoved moved =
        kernels.transport_strata(scratch, upper, columns, rows, place.runoff_edges,
                                 {worker.concentrations.data(), crowded ? worker.held.data() : nullptr,
                                  state.paint.read(place.tile), state.lower.paint.read(place.tile),
                                  result.thickness.read(), result.paint.write(), upper.changes.data()});
    note_moved(moved.pigment, result);
    result.lower.assign(upper.changes.begin(), upper.changes.begin() + moved.changes);
}

void change_lower(LowerStratum& lower, int tile, std::span<const LowerChange> changes) {
    const auto is_two = [](const LowerChange& change) { return change.lower.thickness != 0; };
    if (!lower.is_in(tile) && std::none_of(changes.begin(), changes.end(), is_two)) return;
    std::int32_t* thickness = lower.thickness.write(tile);
    PaintCell* paint = lower.paint.write(tile);
    for (const LowerChange& change : changes) {
        thickness[change.cell] = change.lower.thickness;
        paint[change.cell] = change.lower.paint;
    }
    if (!lower.holds_any(tile)) lower.forget(tile);
}

}  // namespace pastoso::film
