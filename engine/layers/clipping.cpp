#include "layers/clipping.hpp"

#include "core/check.hpp"
#include "layers/apart.hpp"
#include "layers/cutting.hpp"

#include <algorithm>
#include <array>
#include <utility>

namespace pastoso::layers {
namespace {

using film::FilmState;
using grid::kTileCells;

using ChosenCells = std::array<std::uint8_t, kTileCells>;

ChosenCells painted_in(const FilmState& layer, int tile) {
    ChosenCells painted{};
    if (layer.thickness.is_background(tile) && layer.support_mm.is_background(tile)) return painted;
    const film::TileHeights relief_mm = layer.support_mm.read(tile);
    const std::int32_t* wet = layer.thickness.read(tile);
    for (int cell = 0; cell < kTileCells; ++cell) {
        const double paint_mm = relief_mm[cell] + film::thickness_mm(wet[cell]);
        if (paint_mm >= kLeastPaint_mm) painted[static_cast<std::size_t>(cell)] = grid::kWhole;
    }
    return painted;
}

bool is_as_thick(const FilmState& a, const FilmState& b, int tile) {
    return same_tile(a.thickness, b.thickness, tile) && same_tile(a.support_mm, b.support_mm, tile);
}

}  // namespace

grid::Mask painted_cells(const FilmState& layer) {
    grid::MaskBuilder builder(layer.shape);
    for (int tile = 0; tile < layer.shape.tile_count(); ++tile)
        builder.set_tile(tile, painted_in(layer, tile).data());
    return builder.take();
}

ClippedLayer clipped(const FilmState& layer, const FilmState& onto) {
    CutLayer parts = cut(layer, painted_cells(onto));
    parts.inside.strata.evaporated = std::exchange(parts.outside.strata.evaporated, 0);
    return {std::move(parts.inside), std::move(parts.outside)};
}

const FilmState& Clipper::shown(const FilmState& layer, const FilmState& onto) {
    PASTOSO_CHECK(layer.shape == onto.shape);
    const bool afresh = shown_.shape != layer.shape;
    if (afresh) {
        painted_ = grid::Mask(layer.shape);
        bare_ = shown_ = FilmState(layer.shape, layer.cell_mm);
    }
    bool any = afresh;
    for (int tile = 0; tile < layer.shape.tile_count(); ++tile) {
        const bool thicker = afresh || !is_as_thick(onto, onto_, tile);
        const bool elsewhere = thicker && find_painted(tile, onto);
        const bool repainted = afresh || !looks_same(layer, layer_, tile);
        if (elsewhere || repainted) show(tile, layer);
        any = any || thicker || repainted;
    }
    if (any) {
        layer_ = layer;
        onto_ = onto;
    }
    return shown_;
}

bool Clipper::find_painted(int tile, const FilmState& onto) {
    const ChosenCells painted = painted_in(onto, tile);
    if (std::equal(painted.begin(), painted.end(), painted_.read(tile))) return false;
    if (std::find(painted.begin(), painted.end(), grid::kWhole) == painted.end())
        painted_.reset(tile);
    else
        painted_.replace(tile, grid::TileBlock<std::uint8_t>::copy_of(painted.data()));
    return true;
}

void Clipper::show(int tile, const FilmState& layer) {
    const bool none = grid::chooses_none(painted_, tile);
    take_seen_tile(none ? bare_ : layer, tile, shown_);
    if (!none && !grid::chooses_all(painted_, tile)) keep_chosen(painted_, tile, shown_);
}

}  // namespace pastoso::layers
