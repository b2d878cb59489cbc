#include "film/cell/drying.hpp"

#include "film/cell/cell_drying.hpp"

#include <algorithm>
#include <functional>
#include <limits>
#include <vector>

namespace pastoso::film {
namespace {

using grid::kTileSize;
using grid::TileBlock;

/// Quanta of drying time in a second.
constexpr double kQuantaPerSecond = 1.0 / 3600.0 / kPaintQuantum;

/// Quanta of drying time that pass at a cell of the canvas, or kNoTime.
using TimeAt = std::function<std::int32_t(int x, int y)>;
constexpr std::int32_t kNoTime = -1;
constexpr std::int32_t kForEver = std::numeric_limits<std::int32_t>::max();

/// What drying makes of a tile.
struct TileDrying {
    TileBlock<std::int32_t> thickness;
    TileBlock<PaintCell> paint;
    LowerTile lower;
    TileBlock<float> support_mm;
    TileBlock<std::int32_t> soluble_thickness;
    TileBlock<PigmentCell> soluble_pigment;
    TileBlock<StrataOptics> optics;
    TileBlock<PigmentMixture> uppermost;
    DriedTotals fixed;
    std::int64_t evaporated = 0;
    bool any_wet = false, any_dried = false, any_soluble = false;
};

/// Copies what lies below the film once the first cell of the tile becomes part of it.
void open_strata(const FilmState& state, int tile, TileDrying& result) {
    if (result.any_dried) return;
    result.any_dried = true;
    result.support_mm = copied_heights(state.support_mm.read(tile));
    result.soluble_thickness =
        TileBlock<std::int32_t>::copy_of(state.strata.soluble_thickness.read(tile));
    result.soluble_pigment = TileBlock<PigmentCell>::copy_of(state.strata.soluble_pigment.read(tile));
    result.optics = TileBlock<StrataOptics>::copy_of(state.strata.optics.read(tile));
    result.uppermost = TileBlock<PigmentMixture>::copy_of(state.strata.uppermost.read(tile));
}

bool holds_soluble(const TileDrying& tile) {
    const std::int32_t* thickness = tile.soluble_thickness.read();
    const PigmentCell* pigment = tile.soluble_pigment.read();
    for (int cell = 0; cell < grid::kTileCells; ++cell)
        if (!is_empty(pigment[cell], thickness[cell])) return true;
    return false;
}

/// Returns what evaporates of a cell that stays wet.
std::int32_t dry_cell(std::int32_t time, int cell, TileDrying& tile) {
    std::int32_t& thickness = tile.thickness.write()[cell];
    PaintCell& paint = tile.paint.write()[cell];
    if (!tile.lower.any()) return dry_on(time, thickness, paint);
    LowerCell lower = tile.lower.at(cell);
    const std::int32_t thickness_before = thickness;
    const PaintCell before = paint;
    const std::int32_t evaporated = dry_on(time, thickness, paint);
    follow(thickness_before, before, thickness, paint, lower);
    tile.lower.set(cell, lower);
    return evaporated;
}

TileDrying dry_tile(const FilmState& state, int tile, const TimeAt& time_at) {
    TileDrying result;
    result.thickness = TileBlock<std::int32_t>::copy_of(state.thickness.read(tile));
    result.paint = TileBlock<PaintCell>::copy_of(state.paint.read(tile));
    result.lower = LowerTile(state.lower, tile);
    std::int32_t* thickness = result.thickness.write();
    PaintCell* paint = result.paint.write();
    const grid::Rect cells = state.shape.tile_cells(tile);
    for (int y = cells.y0; y < cells.y1; ++y) {
        for (int x = cells.x0; x < cells.x1; ++x) {
            const int cell = grid::Shape::cell_in_tile(x, y);
            if (thickness[cell] == 0) continue;
            const std::int32_t time = time_at(x, y);
            if (time == kNoTime) {
                result.any_wet = true;
                continue;
            }
            if (time < paint[cell][kDryingChannel]) {
                result.evaporated += dry_cell(time, cell, result);
                result.any_wet = true;
                continue;
            }
            open_strata(state, tile, result);
            StrataCell below{
                result.support_mm.write()[cell],      result.soluble_thickness.write()[cell],
                result.soluble_pigment.write()[cell], result.optics.write()[cell],
                result.uppermost.write()[cell],       result.fixed};
            result.evaporated +=
                become_strata(thickness[cell], paint[cell], result.lower.at(cell), below);
            result.lower.clear(cell);
        }
    }
    if (result.any_dried) result.any_soluble = holds_soluble(result);
    return result;
}

void commit(int tile, TileDrying& result, FilmState& state) {
    if (result.any_wet) {
        const TileBlock<std::int32_t> before = state.thickness.block(tile);
        state.thickness.replace(tile, std::move(result.thickness));
        keep_media_shares(state, tile, before.read());
        state.paint.replace(tile, std::move(result.paint));
        result.lower.put_into(state.lower, tile);
    } else {
        state.thickness.reset(tile);
        state.paint.reset(tile);
        state.media.foreign.reset(tile);
        state.lower.forget(tile);
        state.velocity_x.reset(tile);
        state.velocity_y.reset(tile);
    }
    state.strata.evaporated += result.evaporated;
    if (!result.any_dried) return;
    state.support_mm.replace(tile, std::move(result.support_mm));
    replace_soluble(tile, result.any_soluble, std::move(result.soluble_thickness),
                    std::move(result.soluble_pigment), state.strata);
    if (result.fixed == DriedTotals{}) return;
    state.strata.optics.replace(tile, std::move(result.optics));
    state.strata.uppermost.replace(tile, std::move(result.uppermost));
    state.strata.fixed += result.fixed;
}

/// False when there was no wet paint.
bool dry_tiles(FilmState& state, const TimeAt& time_at, core::ThreadPool& pool) {
    std::vector<int> tiles;
    for (int tile = 0; tile < state.shape.tile_count(); ++tile)
        if (!state.thickness.is_background(tile)) tiles.push_back(tile);
    std::vector<TileDrying> results(tiles.size());
    pool.run(tiles.size(),
             [&](std::size_t index, int) { results[index] = dry_tile(state, tiles[index], time_at); });
    for (std::size_t index = 0; index < tiles.size(); ++index)
        commit(tiles[index], results[index], state);
    return !tiles.empty();
}

}  // namespace

double DryingAir::rate_at(double x_mm, double y_mm) const {
    if (fan_radius_mm <= 0.0) return fan;
    const double dx = x_mm - fan_x_mm, dy = y_mm - fan_y_mm;
    const double inside = std::max(0.0, 1.0 - (dx * dx + dy * dy) / (fan_radius_mm * fan_radius_mm));
    return 1.0 + (fan - 1.0) * inside * inside;
}

void dry(FilmState& state, const DryingAir& air, double seconds, core::ThreadPool& pool,
         const grid::Mask* cover) {
    const double quanta = seconds * kQuantaPerSecond;
    const auto time_at = [&](int x, int y) {
        if (cover != nullptr && cover->at(x, y) != 0) return kNoTime;
        const double rate = air.rate_at((x + 0.5) * state.cell_mm, (y + 0.5) * state.cell_mm);
        return static_cast<std::int32_t>(std::min(quanta * rate, double{kForEver}));
    };
    if (dry_tiles(state, time_at, pool)) state.consistencies = Consistencies::several();
}

void dry_now(FilmState& state, core::ThreadPool& pool, const grid::Mask* only) {
    const auto time_at = [&](int x, int y) {
        return only == nullptr || grid::is_chosen(only->at(x, y)) ? kForEver : kNoTime;
    };
    dry_tiles(state, time_at, pool);
}

}  // namespace pastoso::film
