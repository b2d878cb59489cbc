#include "layers/apart.hpp"

#include "core/check.hpp"
#include "film/cell/cell_drying.hpp"

#include <algorithm>

namespace pastoso::layers {
namespace {

using film::FilmState;
using grid::kTileCells;

bool is_level(const float* heights_mm) {
    return std::all_of(heights_mm, heights_mm + kTileCells, [](float height) { return height == 0.0F; });
}

void lift_tile(const Heights& support_mm, const Heights& base_mm, int tile, Heights& relief_mm) {
    if (support_mm.shares_tile(base_mm, tile)) return;
    auto block = film::copied_heights(support_mm.read(tile));
    const film::TileHeights base = base_mm.read(tile);
    for (int cell = 0; cell < kTileCells; ++cell)
        block.write()[cell] -= base[cell];
    if (!is_level(block.read())) relief_mm.replace(tile, std::move(block));
}

void add_tile(const Heights& relief_mm, int tile, Heights& heights_mm) {
    if (relief_mm.is_background(tile)) return;
    const film::TileHeights relief = relief_mm.read(tile);
    float* heights = heights_mm.write(tile);
    for (int cell = 0; cell < kTileCells; ++cell)
        heights[cell] += relief[cell];
}

}  // namespace

FilmState lifted_off(const FilmState& film, const Heights& base_mm) {
    PASTOSO_CHECK(base_mm.shape() == film.shape);
    FilmState layer = film;
    layer.support_mm = Heights(film.shape);
    for (int tile = 0; tile < film.shape.tile_count(); ++tile)
        lift_tile(film.support_mm, base_mm, tile, layer.support_mm);
    return layer;
}

FilmState Lifter::lifted_off(const FilmState& film, const Heights& base_mm) {
    PASTOSO_CHECK(base_mm.shape() == film.shape);
    const bool first = relief_mm_.shape() != film.shape;
    if (first) relief_mm_ = Heights(film.shape);
    for (int tile = 0; tile < film.shape.tile_count(); ++tile) {
        if (!first && film.support_mm.shares_tile(support_mm_, tile) &&
            base_mm.shares_tile(base_mm_, tile))
            continue;
        relief_mm_.reset(tile);
        lift_tile(film.support_mm, base_mm, tile, relief_mm_);
    }
    support_mm_ = film.support_mm;
    base_mm_ = base_mm;
    FilmState layer = film;
    layer.support_mm = relief_mm_;
    return layer;
}

FilmState laid_on(const FilmState& layer, const Heights& base_mm) {
    PASTOSO_CHECK(base_mm.shape() == layer.shape);
    FilmState film = layer;
    film.support_mm = base_mm;
    for (int tile = 0; tile < layer.shape.tile_count(); ++tile)
        add_tile(layer.support_mm, tile, film.support_mm);
    return film;
}

void raise_by(const FilmState& layer, Heights& heights_mm) {
    for (int tile = 0; tile < layer.shape.tile_count(); ++tile) {
        add_tile(layer.support_mm, tile, heights_mm);
        if (layer.thickness.is_background(tile)) continue;
        const std::int32_t* thickness = layer.thickness.read(tile);
        float* heights = heights_mm.write(tile);
        for (int cell = 0; cell < kTileCells; ++cell)
            heights[cell] += wet_height_mm(thickness[cell]);
    }
}

float wet_height_mm(std::int32_t thickness_quanta) {
    constexpr std::int32_t kStep = film::kQuantaPerSupport;
    return film::thickness_mm((thickness_quanta + kStep / 2) / kStep * kStep);
}

bool holds_paint(const FilmState& layer, int tile) {
    return !layer.thickness.is_background(tile) || !layer.paint.is_background(tile) ||
           holds_dry_paint(layer, tile);
}

bool holds_paint(const FilmState& layer, int x, int y) {
    return layer.thickness.at(x, y) > 0 || holds_dry_paint(layer, x, y);
}

bool holds_dry_paint(const FilmState& layer, int tile) {
    return !layer.support_mm.is_background(tile) || !layer.strata.optics.is_background(tile) ||
           !layer.strata.soluble_thickness.is_background(tile) ||
           !layer.strata.soluble_pigment.is_background(tile);
}

bool holds_dry_paint(const FilmState& layer, int x, int y) {
    return layer.support_mm.at(x, y) != 0.0F || layer.strata.optics.at(x, y) != film::kClearStrata ||
           !film::is_empty(layer.strata.soluble_pigment.at(x, y),
                           layer.strata.soluble_thickness.at(x, y));
}

grid::Rect painted_area(const FilmState& layer) {
    grid::Rect area;
    for (int tile = 0; tile < layer.shape.tile_count(); ++tile) {
        if (!holds_paint(layer, tile)) continue;
        const grid::Rect cells = layer.shape.tile_cells(tile);
        for (int y = cells.y0; y < cells.y1; ++y)
            for (int x = cells.x0; x < cells.x1; ++x)
                if (holds_paint(layer, x, y)) area = grid::bounding_box(area, {x, y, x + 1, y + 1});
    }
    return area;
}

bool looks_same(const FilmState& a, const FilmState& b, int tile) {
    return same_tile(a.thickness, b.thickness, tile) && same_tile(a.paint, b.paint, tile) &&
           same_tile(a.lower.paint, b.lower.paint, tile) &&
           same_tile(a.support_mm, b.support_mm, tile) &&
           same_tile(a.strata.soluble_thickness, b.strata.soluble_thickness, tile) &&
           same_tile(a.strata.soluble_pigment, b.strata.soluble_pigment, tile) &&
           same_tile(a.strata.optics, b.strata.optics, tile) &&
           same_tile(a.strata.uppermost, b.strata.uppermost, tile);
}

void take_seen_tile(const FilmState& from, int tile, FilmState& to) {
    share_tile(from.thickness, tile, to.thickness);
    share_tile(from.paint, tile, to.paint);
    share_tile(from.lower.thickness, tile, to.lower.thickness);
    share_tile(from.lower.paint, tile, to.lower.paint);
    share_tile(from.support_mm, tile, to.support_mm);
    share_tile(from.strata.soluble_thickness, tile, to.strata.soluble_thickness);
    share_tile(from.strata.soluble_pigment, tile, to.strata.soluble_pigment);
    share_tile(from.strata.optics, tile, to.strata.optics);
    share_tile(from.strata.uppermost, tile, to.strata.uppermost);
}

void take_tile(const FilmState& from, int tile, FilmState& to) {
    take_seen_tile(from, tile, to);
    share_tile(from.worked.thickness, tile, to.worked.thickness);
    film::take_media(from, tile, to);
    share_tile(from.velocity_x, tile, to.velocity_x);
    share_tile(from.velocity_y, tile, to.velocity_y);
}

}  // namespace pastoso::layers
