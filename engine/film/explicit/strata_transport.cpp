#include "film/explicit/strata_transport.hpp"

#include "film/explicit/concentration_block.hpp"

#include <algorithm>
#include <limits>

namespace pastoso::film {
namespace {

using grid::TileBlock;

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
    TileScratch& scratch = worker.tile;
    StrataScratch& upper = *worker.strata;
    upper.concentrations.resize(kConcentrationCount);
    Concentrations concentrations{worker.concentrations.data(), upper.concentrations.data()};
    gather_concentrations(state, place.columns, place.rows, place.tile_x, concentrations);
    const bool crowded = concentrations.largest > kCrowded / 2;
    if (crowded) {
        gather_held(state, place.columns, place.rows, worker.held);
        halve_room(upper.quanta, columns, rows, worker.held);
    }
    const PaintCell* held = crowded ? worker.held.data() : nullptr;
    const auto& kernels = core::kernels<TileKernels>();
    kernels.split_strata(profile, static_cast<float>(state.cell_mm / kThicknessQuantum_mm), scratch,
                         upper);
    const PaintCell* lower_before = state.lower.paint.read(place.tile);
    auto lower = transported(place, scratch, worker.concentrations.data(), held, lower_before, result);
    scratch.flux_x = upper.flux_x;
    scratch.flux_y = upper.flux_y;
    scratch.block.quanta = upper.quanta;
    if (scratch.large_fluxes) scratch.supply = upper.supply;
    const PaintCell* whole_before = state.paint.read(place.tile);
    result.paint = transported(place, scratch, upper.concentrations.data(), held, whole_before, result);
    auto lower_thickness = TileBlock<std::int32_t>::filled(0);
    kernels.join_strata(upper, columns, rows,
                        {whole_before, lower_before, result.thickness.read(), lower_thickness.write(),
                         lower.write(), result.paint.write()});
    result.lower = LowerTile(std::move(lower_thickness), std::move(lower));
    result.strata_moved = true;
}

}  // namespace pastoso::film
