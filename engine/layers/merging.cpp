#include "layers/merging.hpp"

#include "core/check.hpp"
#include "film/cell/cell_drying.hpp"
#include "layers/apart.hpp"

#include <utility>
#include <vector>

namespace pastoso::layers {
namespace {

using film::FilmState;
using grid::kTileCells;
using grid::TileBlock;

/// All that a tile of a layer holds, for writing.
struct LayerTile {
    TileBlock<std::int32_t> thickness;
    TileBlock<film::PaintCell> paint;
    film::LowerTile wet_below;
    TileBlock<std::int32_t> worked;
    TileBlock<float> relief_mm;
    TileBlock<std::int32_t> soluble_thickness;
    TileBlock<film::PigmentCell> soluble_pigment;
    TileBlock<film::StrataOptics> optics;
    TileBlock<film::PigmentMixture> uppermost;
    film::DriedTotals fixed;  ///< that became so
    std::int64_t evaporated = 0;
    bool any_soluble = false;

    film::StrataCell strata(int cell) {
        return {relief_mm.write()[cell], soluble_thickness.write()[cell], soluble_pigment.write()[cell],
                optics.write()[cell],    uppermost.write()[cell],         fixed};
    }
};

template <class T>
TileBlock<T> copy(const grid::TiledField<T>& field, int tile) {
    return TileBlock<T>::copy_of(field.read(tile));
}

LayerTile copy_of_tile(const FilmState& layer, int tile) {
    const film::Strata& strata = layer.strata;
    return {copy(layer.thickness, tile),
            copy(layer.paint, tile),
            film::LowerTile(layer.lower, tile),
            copy(layer.worked.thickness, tile),
            film::copied_heights(layer.support_mm.read(tile)),
            copy(strata.soluble_thickness, tile),
            copy(strata.soluble_pigment, tile),
            copy(strata.optics, tile),
            copy(strata.uppermost, tile),
            {},
            0};
}

void dry(LayerTile& tile, int cell) {
    if (tile.thickness.read()[cell] == 0) return;
    tile.evaporated += film::become_strata(tile.thickness.write()[cell], tile.paint.write()[cell],
                                           tile.wet_below.at(cell), tile.strata(cell));
    tile.wet_below.clear(cell);
    tile.worked.write()[cell] = 0;
}

/// Makes everything in the cell fixed.
void fix(LayerTile& tile, int cell) {
    dry(tile, cell);
    film::seal(tile.strata(cell));
}

bool holds_soluble(const LayerTile& tile, int cell) {
    return !film::is_empty(tile.soluble_pigment.read()[cell], tile.soluble_thickness.read()[cell]);
}

bool is_dry_in(const LayerTile& tile, int cell) {
    return tile.relief_mm.read()[cell] != 0.0F || holds_soluble(tile, cell) ||
           tile.optics.read()[cell] != film::kClearStrata;
}

/// Puts the dry paint of `upper` over that of `lower`, which is all fixed.
void lay_strata(const LayerTile& upper, int cell, LayerTile& lower) {
    lower.relief_mm.write()[cell] += upper.relief_mm.read()[cell];
    lower.soluble_thickness.write()[cell] = upper.soluble_thickness.read()[cell];
    lower.soluble_pigment.write()[cell] = upper.soluble_pigment.read()[cell];
    const film::StrataOptics& above = upper.optics.read()[cell];
    if (above == film::kClearStrata) return;
    lower.optics.write()[cell] = film::laid_over(above, lower.optics.read()[cell]);
    lower.uppermost.write()[cell] = upper.uppermost.read()[cell];
}

bool has_capacity(std::int32_t lower, std::int32_t upper) {
    return upper <= film::capacity_left_quanta(lower);
}

/// Puts the wet paint of `upper` onto what is wet below; that becomes the lower stratum, all of it.
void pour(const LayerTile& upper, int cell, LayerTile& lower) {
    const std::int32_t thickness = upper.thickness.read()[cell];
    if (thickness == 0) return;
    if (!has_capacity(lower.thickness.read()[cell], thickness)) dry(lower, cell);
    const std::int32_t below = lower.thickness.read()[cell];
    lower.wet_below.set(
        cell, below > 0 ? film::LowerCell{below, lower.paint.read()[cell]} : upper.wet_below.at(cell));
    lower.thickness.write()[cell] += thickness;
    lower.worked.write()[cell] += upper.worked.read()[cell];
    for (int k = 0; k < film::kPaintChannels; ++k)
        lower.paint.write()[cell][k] += upper.paint.read()[cell][k];
}

void merge_cell(LayerTile& upper, double opacity, int cell, LayerTile& lower) {
    if (opacity < 1.0) {
        fix(upper, cell);
        film::StrataOptics& optics = upper.optics.write()[cell];
        optics = film::faded(optics, static_cast<float>(opacity));
    }
    if (is_dry_in(upper, cell)) {
        fix(lower, cell);
        lay_strata(upper, cell, lower);
    }
    pour(upper, cell, lower);
}

LayerTile merged_tile(const FilmState& lower, const FilmState& upper, double opacity, int tile) {
    LayerTile result = copy_of_tile(lower, tile);
    LayerTile above = copy_of_tile(upper, tile);
    const grid::Rect cells = lower.shape.tile_cells(tile);
    for (int y = cells.y0; y < cells.y1; ++y) {
        for (int x = cells.x0; x < cells.x1; ++x) {
            const int cell = grid::Shape::cell_in_tile(x, y);
            merge_cell(above, opacity, cell, result);
            result.any_soluble = result.any_soluble || holds_soluble(result, cell);
        }
    }
    result.fixed += above.fixed;
    result.evaporated += above.evaporated;
    return result;
}

void commit(int tile, LayerTile& from, FilmState& layer) {
    layer.thickness.replace(tile, std::move(from.thickness));
    layer.paint.replace(tile, std::move(from.paint));
    from.wet_below.put_into(layer.lower, tile);
    layer.worked.replace(tile, std::move(from.worked));
    layer.support_mm.replace(tile, std::move(from.relief_mm));
    layer.velocity_x.reset(tile);
    layer.velocity_y.reset(tile);
    film::replace_soluble(tile, from.any_soluble, std::move(from.soluble_thickness),
                          std::move(from.soluble_pigment), layer.strata);
    layer.strata.optics.replace(tile, std::move(from.optics));
    layer.strata.uppermost.replace(tile, std::move(from.uppermost));
    layer.strata.fixed += from.fixed;
    layer.strata.evaporated += from.evaporated;
}

/// Where the media of both layers stand in the merged one.
struct MergedPlaces {
    std::vector<int> lower, upper;
};

/// Says which media are in a tile whose thickness is what became of both: the upper layer's wet paint,
/// unless it dried, on the lower one's, unless that did.
void mix_media(const FilmState& lower, const FilmState& upper, const MergedPlaces& places, int tile,
               FilmState& result) {
    auto amounts = TileBlock<film::MediaCell>::filled({});
    for (int cell = 0; cell < kTileCells; ++cell) {
        const std::int32_t below = lower.thickness.read(tile)[cell];
        const std::int32_t above = upper.thickness.read(tile)[cell];
        const std::int32_t whole = result.thickness.read(tile)[cell];
        if (whole == 0) continue;
        film::MediaCell& media = amounts.write()[cell];
        if (whole == below || whole == below + above)
            media = film::at_places(film::media_in(lower, tile, cell), places.lower);
        if (whole == below) continue;
        const film::MediaCell added = film::at_places(film::media_in(upper, tile, cell), places.upper);
        for (int k = 0; k < film::kMostMedia; ++k)
            media[k] += added[k];
    }
    film::set_media(result, tile, std::move(amounts));
}

}  // namespace

FilmState merged(const FilmState& lower, const FilmState& upper, double upper_opacity,
                 core::ThreadPool& pool) {
    PASTOSO_CHECK(lower.shape == upper.shape);
    FilmState result = lower;
    std::vector<int> both;
    for (int tile = 0; tile < lower.shape.tile_count(); ++tile) {
        if (!holds_paint(upper, tile)) continue;
        if (upper_opacity == 1.0 && !holds_paint(lower, tile))
            take_tile(upper, tile, result);
        else
            both.push_back(tile);
    }
    std::vector<LayerTile> tiles(both.size());
    pool.run(both.size(), [&](std::size_t index, int) {
        tiles[index] = merged_tile(lower, upper, upper_opacity, both[index]);
    });
    const MergedPlaces places{film::places_of_media(lower, result),
                              film::places_of_media(upper, result)};
    for (std::size_t index = 0; index < both.size(); ++index) {
        commit(both[index], tiles[index], result);
        if (result.media.are_several()) mix_media(lower, upper, places, both[index], result);
    }
    result.strata.fixed += upper.strata.fixed;
    result.strata.evaporated += upper.strata.evaporated;
    result.consistencies = film::wet_consistencies(lower);
    result.consistencies.add(film::wet_consistencies(upper));
    if (!both.empty()) result.consistencies = film::Consistencies::several();
    return result;
}

}  // namespace pastoso::layers
