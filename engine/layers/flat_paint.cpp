#include "layers/flat_paint.hpp"

#include "film/cell/cell_drying.hpp"
#include "layers/picture_means.hpp"
#include "pigment/rgb_bands.hpp"
#include "pigment/rgb_paint.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>
#include <vector>

namespace pastoso::layers {
namespace {

using film::FilmState;
using grid::TileBlock;

/// Relief in steps of the support's grid.
std::int32_t relief_steps(float coverage) {
    return static_cast<std::int32_t>(
        std::lround(coverage * static_cast<float>(kFlatPaint_mm / film::kSupportQuantum_mm)));
}

/// The pigment of so thick a film, in quanta.
film::PigmentCell pigment_of(const pigment::Coefficients& paint, double thickness_mm) {
    film::PigmentCell pigment{};
    for (int k = 0; k < film::kPigmentChannels; ++k)
        pigment[k] =
            static_cast<std::int32_t>(std::lround(paint[k] * thickness_mm / film::kPaintQuantum));
    return pigment;
}

/// All that a tile of the layer holds.
struct FlatTile {
    TileBlock<float> relief_mm = TileBlock<float>::filled(0.0F);
    TileBlock<film::StrataOptics> optics = TileBlock<film::StrataOptics>::filled(film::kClearStrata);
    TileBlock<film::PigmentMixture> uppermost = TileBlock<film::PigmentMixture>::filled({});
    film::DriedTotals fixed;
};

void put(const CoveredColour& colour, int cell, FlatTile& tile) {
    const std::int32_t steps = relief_steps(colour.coverage);
    if (steps == 0) return;
    const std::int32_t thickness = steps * film::kQuantaPerSupport;
    const pigment::Bands reflectance = pigment::rgb_bands(colour.colour);
    const film::PigmentCell pigment =
        pigment_of(pigment::paint_of_bands(reflectance), steps * film::kSupportQuantum_mm);
    tile.relief_mm.write()[cell] = static_cast<float>(steps * film::kSupportQuantum_mm);
    tile.optics.write()[cell] = picture_optics(reflectance, colour.coverage);
    tile.uppermost.write()[cell] = film::mixture_of(pigment.data(), thickness);
    tile.fixed.thickness += thickness;
    for (int k = 0; k < film::kPigmentChannels; ++k)
        tile.fixed.pigment[k] += pigment[k];
}

/// Nothing where the picture covers none of the tile.
std::optional<FlatTile> tile_of(const PictureMeans& means, const grid::Rect& cells) {
    FlatTile tile;
    const grid::Rect touched = grid::intersection(means.cells(), cells);
    for (int y = touched.y0; y < touched.y1; ++y)
        for (int x = touched.x0; x < touched.x1; ++x)
            put(means.at(x, y), grid::Shape::cell_in_tile(x, y), tile);
    if (tile.fixed.thickness == 0) return std::nullopt;
    return tile;
}

}  // namespace

film::StrataOptics picture_optics(const pigment::Bands& reflectance, float coverage) {
    film::StrataOptics optics{};
    for (int band = 0; band < pigment::kBands; ++band)
        film::set_optics(band, pigment::laid_in_part(reflectance[band], coverage), optics);
    return optics;
}

FilmState flat_paint(const pigment::Picture& picture, const PicturePlace& place, grid::Shape shape,
                     double cell_mm, core::ThreadPool& pool) {
    const PictureMeans means(picture, place, cell_mm, shape);
    std::vector<std::optional<FlatTile>> tiles(static_cast<std::size_t>(shape.tile_count()));
    const auto make = [&](std::size_t tile, int) {
        tiles[tile] = tile_of(means, shape.tile_cells(static_cast<int>(tile)));
    };
    pool.run(tiles.size(), make);
    FilmState layer(shape, cell_mm);
    for (int tile = 0; tile < shape.tile_count(); ++tile) {
        std::optional<FlatTile>& made = tiles[static_cast<std::size_t>(tile)];
        if (!made) continue;
        layer.support_mm.replace(tile, film::HeightBlock::smallest_of(std::move(made->relief_mm)));
        layer.strata.optics.replace(tile, std::move(made->optics));
        layer.strata.uppermost.replace(tile, std::move(made->uppermost));
        layer.strata.fixed += made->fixed;
    }
    return layer;
}

}  // namespace pastoso::layers
