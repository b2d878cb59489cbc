#include "film/cell/dissolving.hpp"

#include "core/elementary.hpp"
#include "film/cell/cell_drying.hpp"
#include "film/support/support.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace pastoso::film {
namespace {

using grid::kTileCells;
using grid::TileBlock;

struct TileDissolving {
    TileBlock<std::int32_t> thickness;
    TileBlock<PaintCell> paint;
    TileBlock<float> support_mm;
    TileBlock<std::int32_t> soluble_thickness;
    TileBlock<PigmentCell> soluble_pigment;
    bool any_left = false;
};

/// The share of an amount, rounded up to whole steps, so that nothing stays for ever; at most `most`.
std::int32_t share_of(std::int32_t amount, double share, std::int32_t step, std::int32_t most) {
    const auto steps = static_cast<std::int64_t>(std::ceil(amount * share / step));
    return static_cast<std::int32_t>(std::min<std::int64_t>(steps * step, std::min(amount, most)));
}

void dissolve_cell(double seconds, int cell, TileDissolving& tile) {
    std::int32_t& thickness = tile.thickness.write()[cell];
    std::int32_t& dry = tile.soluble_thickness.write()[cell];
    PaintCell& paint = tile.paint.write()[cell];
    const double solvent = 1.0 - static_cast<double>(solids(thickness, paint)) / thickness;
    const double share = 1.0 - core::exponential(-seconds * solvent / kDissolvingTime_s);

    const std::int32_t most = std::numeric_limits<std::int32_t>::max();
    const std::int32_t capacity_left =
        capacity_left_quanta(thickness) / kQuantaPerSupport * kQuantaPerSupport;
    const std::int32_t moved = share_of(dry, share, kQuantaPerSupport, capacity_left);
    dry -= moved;
    thickness += moved;
    paint[kSolidsChannel] += static_cast<std::int32_t>(moved / kQuantaPerCarried);
    tile.support_mm.write()[cell] -= thickness_mm(moved);
    PigmentCell& pigment = tile.soluble_pigment.write()[cell];
    for (int k = 0; k < kPigmentChannels; ++k) {
        const std::int32_t quanta = share_of(pigment[k], share, 1, most - paint[k]);
        pigment[k] -= quanta;
        paint[k] += quanta;
    }
}

TileDissolving dissolve_tile(const FilmState& state, int tile, double seconds, const grid::Mask* cover) {
    const Strata& strata = state.strata;
    TileDissolving result{TileBlock<std::int32_t>::copy_of(state.thickness.read(tile)),
                          TileBlock<PaintCell>::copy_of(state.paint.read(tile)),
                          copied_heights(state.support_mm.read(tile)),
                          TileBlock<std::int32_t>::copy_of(strata.soluble_thickness.read(tile)),
                          TileBlock<PigmentCell>::copy_of(strata.soluble_pigment.read(tile))};
    for (int cell = 0; cell < kTileCells; ++cell) {
        const bool covered = cover != nullptr && cover->read(tile)[cell] != 0;
        if (result.thickness.read()[cell] > 0 && !covered) dissolve_cell(seconds, cell, result);
        result.any_left = result.any_left || !is_empty(result.soluble_pigment.read()[cell],
                                                       result.soluble_thickness.read()[cell]);
    }
    return result;
}

void commit(int tile, TileDissolving& result, FilmState& state) {
    const TileBlock<std::int32_t> before = state.thickness.block(tile);
    state.thickness.replace(tile, std::move(result.thickness));
    keep_media_shares(state, tile, before.read());
    state.paint.replace(tile, std::move(result.paint));
    state.support_mm.replace(tile, std::move(result.support_mm));
    replace_soluble(tile, result.any_left, std::move(result.soluble_thickness),
                    std::move(result.soluble_pigment), state.strata);
}

}  // namespace

void dissolve(FilmState& state, double seconds, core::ThreadPool& pool, const grid::Mask* cover) {
    std::vector<int> tiles;
    for (int tile = 0; tile < state.shape.tile_count(); ++tile) {
        if (!state.thickness.is_background(tile) && !state.strata.soluble_pigment.is_background(tile))
            tiles.push_back(tile);
    }
    std::vector<TileDissolving> results(tiles.size());
    pool.run(tiles.size(), [&](std::size_t index, int) {
        results[index] = dissolve_tile(state, tiles[index], seconds, cover);
    });
    for (std::size_t index = 0; index < tiles.size(); ++index)
        commit(tiles[index], results[index], state);
}

}  // namespace pastoso::film
