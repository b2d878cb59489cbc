#include "film/cell/lower_stratum.hpp"

#include "film/cell/tile_quanta.hpp"
#include "film/state.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace pastoso::film {
bool LowerStratum::holds_any(int tile) const {
    return is_in(tile) && any_quanta(thickness.read(tile));
}

void LowerStratum::forget(int tile) {
    thickness.reset(tile);
    paint.reset(tile);
}

void LowerStratum::replace(int tile, grid::TileBlock<std::int32_t> tile_thickness,
                           grid::TileBlock<PaintCell> tile_paint) {
    if (!any_quanta(tile_thickness.read())) return forget(tile);
    thickness.replace(tile, std::move(tile_thickness));
    paint.replace(tile, std::move(tile_paint));
}

bool is_part_of(const LowerCell& lower, std::int32_t thickness, const PaintCell& paint) {
    if (lower.thickness == 0) return lower.paint == PaintCell{};
    if (lower.thickness < 0 || lower.thickness >= thickness) return false;
    for (int k = 0; k < kPaintChannels; ++k)
        if (lower.paint[k] < 0 || lower.paint[k] > paint[k]) return false;
    return true;
}

bool looks_like_one(const LowerCell& lower, std::int32_t thickness, const PaintCell& paint) {
    const std::int32_t rest = thickness - lower.thickness;
    if (std::min(lower.thickness, rest) < kLeastStratum_quanta) return true;
    for (int k = 0; k < kPigmentChannels; ++k) {
        const double below = static_cast<double>(lower.paint[k]) / lower.thickness;
        const double above = static_cast<double>(paint[k] - lower.paint[k]) / rest;
        const double like =
            std::max(kLikeShare * std::max(above, below), kNoColour / kPaintQuantum / thickness);
        if (std::abs(above - below) > like) return false;
    }
    return true;
}

PaintCell upper_paint(const PaintCell& lower, const PaintCell& whole) {
    PaintCell upper;
    for (int k = 0; k < kPaintChannels; ++k)
        upper[k] = whole[k] - lower[k];
    return upper;
}

LowerTile::LowerTile(const LowerStratum& from, int tile) {
    if (!from.is_in(tile)) return;
    thickness_ = grid::TileBlock<std::int32_t>::copy_of(from.thickness.read(tile));
    paint_ = grid::TileBlock<PaintCell>::copy_of(from.paint.read(tile));
}

LowerCell LowerTile::at(int cell) const {
    return any() ? LowerCell{thickness_.read()[cell], paint_.read()[cell]} : LowerCell{};
}

void LowerTile::set(int cell, const LowerCell& lower) {
    if (!any()) {
        if (lower.thickness == 0) return;
        thickness_ = grid::TileBlock<std::int32_t>::filled(0);
        paint_ = grid::TileBlock<PaintCell>::filled({});
    }
    thickness_.write()[cell] = lower.thickness;
    paint_.write()[cell] = lower.paint;
}

void LowerTile::clear(int cell) {
    set(cell, {});
}

void LowerTile::put_into(LowerStratum& stratum, int tile) {
    if (!any()) return stratum.forget(tile);
    stratum.replace(tile, std::move(thickness_), std::move(paint_));
}

bool join_like_strata(FilmState& state, int tile) {
    if (!state.lower.is_in(tile)) return false;
    const std::int32_t* thickness = state.thickness.read(tile);
    const PaintCell* paint = state.paint.read(tile);
    LowerTile lower(state.lower, tile);
    bool changed = !state.lower.holds_any(tile);
    for (int cell = 0; cell < grid::kTileCells; ++cell) {
        const LowerCell below = lower.at(cell);
        if (below.thickness == 0 || !looks_like_one(below, thickness[cell], paint[cell])) continue;
        lower.clear(cell);
        changed = true;
    }
    if (changed) lower.put_into(state.lower, tile);
    return changed;
}

}  // namespace pastoso::film
