#include "layers/tracing.hpp"

#include "core/check.hpp"
#include "layers/apart.hpp"
#include "layers/flat_paint.hpp"
#include "layers/picture_means.hpp"
#include "pigment/rgb_bands.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

namespace pastoso::layers {
namespace {

using StrataBlock = grid::TileBlock<film::StrataOptics>;

constexpr float kCode = 65535.0F;

std::uint16_t code_of(float share) {
    return static_cast<std::uint16_t>(std::lround(kCode * std::clamp(share, 0.0F, 1.0F)));
}

PictureCell cell_of(const CoveredColour& colour) {
    PictureCell cell{.coverage = code_of(colour.coverage)};
    const pigment::Bands bands = pigment::rgb_bands(colour.colour);
    for (int band = 0; band < pigment::kBands; ++band)
        cell.reflectance[band] = code_of(bands[band]);
    return cell;
}

grid::TileBlock<PictureCell> block_of(const PictureMeans& means, const grid::Rect& touched) {
    auto block = grid::TileBlock<PictureCell>::filled({});
    for (int y = touched.y0; y < touched.y1; ++y)
        for (int x = touched.x0; x < touched.x1; ++x)
            block.write()[grid::Shape::cell_in_tile(x, y)] = cell_of(means.at(x, y));
    return block;
}

StrataBlock block_of(const PictureCell* cells, float opacity) {
    StrataBlock block = StrataBlock::uninitialised();
    for (int cell = 0; cell < grid::kTileCells; ++cell) {
        pigment::Bands reflectance{};
        for (int band = 0; band < pigment::kBands; ++band)
            reflectance[band] = cells[cell].reflectance[band] / kCode;
        block.write()[cell] = picture_optics(reflectance, opacity * cells[cell].coverage / kCode);
    }
    return block;
}

/// Runs make(tile), which gives a block, for each of these tiles.
template <class Field, class Make>
void replace_tiles(const std::vector<int>& tiles, Field& field, core::ThreadPool& pool,
                   const Make& make) {
    pool.run(tiles.size(),
             [&](std::size_t index, int) { field.replace(tiles[index], make(tiles[index])); });
}

StrataBlock block_over(const film::StrataOptics* upper, const film::StrataOptics* lower) {
    StrataBlock block = StrataBlock::uninitialised();
    for (int cell = 0; cell < grid::kTileCells; ++cell)
        block.write()[cell] = film::laid_over(upper[cell], lower[cell]);
    return block;
}

bool same_tile(const PictureStrata& a, const PictureStrata& b, int tile) {
    return a.shares_tile(b, tile) || (a.is_background(tile) && b.is_background(tile));
}

}  // namespace

PictureCells picture_cells(const pigment::Picture& picture, const PicturePlace& place, grid::Shape shape,
                           double cell_mm, core::ThreadPool& pool) {
    const PictureMeans means(picture, place, cell_mm, shape);
    const auto touched = [&](int tile) {
        return grid::intersection(means.cells(), shape.tile_cells(tile));
    };
    std::vector<int> tiles;
    for (int tile = 0; tile < shape.tile_count(); ++tile)
        if (!touched(tile).empty()) tiles.push_back(tile);
    PictureCells cells(shape);
    replace_tiles(tiles, cells, pool, [&](int tile) { return block_of(means, touched(tile)); });
    return cells;
}

PictureStrata picture_strata(const PictureCells& cells, double opacity, core::ThreadPool& pool) {
    std::vector<int> tiles;
    for (int tile = 0; tile < cells.tile_count(); ++tile)
        if (!cells.is_background(tile)) tiles.push_back(tile);
    PictureStrata strata(cells.shape(), film::kClearStrata);
    replace_tiles(tiles, strata, pool,
                  [&](int tile) { return block_of(cells.read(tile), static_cast<float>(opacity)); });
    return strata;
}

film::FilmState TracedView::of(const film::FilmState& seen, const PictureStrata& picture,
                               core::ThreadPool& pool) {
    PASTOSO_CHECK(seen.shape == picture.shape());
    const PictureStrata& above = seen.strata.optics;
    const bool afresh = result_.shape() != seen.shape;
    if (afresh) result_ = PictureStrata(seen.shape, film::kClearStrata);
    std::vector<int> composed;
    for (int tile = 0; tile < above.tile_count(); ++tile) {
        if (!afresh && same_tile(above, above_, tile) && same_tile(picture, picture_, tile)) continue;
        if (above.is_background(tile))
            share_tile(picture, tile, result_);
        else if (picture.is_background(tile))
            share_tile(above, tile, result_);
        else
            composed.push_back(tile);
    }
    replace_tiles(composed, result_, pool,
                  [&](int tile) { return block_over(above.read(tile), picture.read(tile)); });
    above_ = above;
    picture_ = picture;
    film::FilmState traced = seen;
    traced.strata.optics = result_;
    return traced;
}

}  // namespace pastoso::layers
