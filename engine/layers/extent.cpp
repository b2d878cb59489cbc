#include "layers/extent.hpp"

#include "layers/cutting.hpp"

#include <algorithm>

namespace pastoso::layers {
namespace {

/// Cells beside `inner` get the height of the nearest cell in it.
void go_on_beyond(const grid::Rect& inner, Heights& heights_mm) {
    const grid::Shape shape = heights_mm.shape();
    for (int y = 0; y < shape.height; ++y)
        for (int x = 0; x < shape.width; ++x) {
            const int near_x = std::clamp(x, inner.x0, inner.x1 - 1);
            const int near_y = std::clamp(y, inner.y0, inner.y1 - 1);
            if (near_x != x || near_y != y) heights_mm.set(x, y, heights_mm.at(near_x, near_y));
        }
}

/// Tiles may come apart: each cell tells its media before.
void put_media_on_extent(const film::FilmState& layer, const grid::Extent& extent,
                         film::FilmState& result) {
    result.media.numbers = layer.media.numbers;
    if (!layer.media.are_several()) return;
    grid::TiledField<film::MediaCell> told(layer.shape), put(extent.shape);
    for (int tile = 0; tile < layer.shape.tile_count(); ++tile) {
        if (layer.thickness.is_background(tile)) continue;
        for (int cell = 0; cell < grid::kTileCells; ++cell)
            told.write(tile)[cell] = film::media_in(layer, tile, cell);
    }
    grid::put_on_extent(told, extent, put);
    for (int tile = 0; tile < extent.shape.tile_count(); ++tile)
        if (!put.is_background(tile)) film::set_media(result, tile, put.block(tile));
}

}  // namespace

film::FilmState on_extent(const film::FilmState& layer, const grid::Extent& extent) {
    film::FilmState result(extent.shape, layer.cell_mm);
    const film::Strata& strata = layer.strata;
    grid::put_on_extent(layer.thickness, extent, result.thickness);
    grid::put_on_extent(layer.paint, extent, result.paint);
    grid::put_on_extent(layer.lower.thickness, extent, result.lower.thickness);
    grid::put_on_extent(layer.lower.paint, extent, result.lower.paint);
    grid::put_on_extent(layer.worked.thickness, extent, result.worked.thickness);
    grid::put_on_extent(layer.support_mm, extent, result.support_mm);
    grid::put_on_extent(strata.soluble_thickness, extent, result.strata.soluble_thickness);
    grid::put_on_extent(strata.soluble_pigment, extent, result.strata.soluble_pigment);
    grid::put_on_extent(strata.optics, extent, result.strata.optics);
    grid::put_on_extent(strata.uppermost, extent, result.strata.uppermost);
    put_media_on_extent(layer, extent, result);
    result.consistencies = layer.consistencies;
    result.strata.evaporated = strata.evaporated;
    result.strata.fixed =
        share_fixed(strata.fixed, fixed_relief_quanta(result), fixed_relief_quanta(layer));
    return result;
}

Heights widened(const Heights& heights_mm, const grid::Extent& extent) {
    Heights result(extent.shape);
    grid::put_on_extent(heights_mm, extent, result);
    const grid::Shape from = heights_mm.shape();
    const grid::Rect inner = grid::intersection(
        extent.shape.cells(), {-extent.x0, -extent.y0, from.width - extent.x0, from.height - extent.y0});
    if (!inner.empty()) go_on_beyond(inner, result);
    return result;
}

}  // namespace pastoso::layers
