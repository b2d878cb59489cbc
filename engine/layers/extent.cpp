#include "layers/extent.hpp"

#include "layers/cell_fields.hpp"
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
    MediaCells put(extent.shape);
    grid::put_on_extent(told_media(layer), extent, put);
    put_media(put, result);
}

}  // namespace

film::FilmState on_extent(const film::FilmState& layer, const grid::Extent& extent) {
    film::FilmState result(extent.shape, layer.cell_mm);
    for_each_cell_field(
        [&](const auto& field, auto& moved) { grid::put_on_extent(field, extent, moved); }, layer,
        result);
    put_media_on_extent(layer, extent, result);
    result.consistencies = layer.consistencies;
    result.strata.evaporated = layer.strata.evaporated;
    result.strata.fixed =
        share_fixed(layer.strata.fixed, fixed_relief_quanta(result), fixed_relief_quanta(layer));
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
