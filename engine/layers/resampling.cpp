#include "layers/resampling.hpp"

#include "film/cell/cell_drying.hpp"
#include "layers/cutting.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <utility>
#include <vector>

namespace pastoso::layers {
namespace {

using film::FilmState;
using grid::kTileCells;
using grid::TileBlock;

/// Sums of shares of cells.
struct CellSum {
    double thickness = 0.0;
    std::array<double, film::kPaintChannels> paint{};
    bool any_upper = false;  ///< of two wet strata
    double upper_thickness = 0.0;
    std::array<double, film::kPaintChannels> upper_paint{};
    double worked_thickness = 0.0;
    std::array<double, film::kMostMedia> media{};
    double relief_mm = 0.0;
    double soluble_thickness = 0.0;
    std::array<double, film::kPigmentChannels> soluble_pigment{};
    std::array<double, std::tuple_size_v<film::StrataOptics>> optics{};
    double covered = 0.0;  ///< by all shares that were added
    double largest = 0.0;
    film::PigmentMixture uppermost{};  ///< of the largest share
};

template <class Values, class Sums>
void add_shares(const Values& values, double share, Sums& sums) {
    for (std::size_t k = 0; k < sums.size(); ++k)
        sums[k] += share * values[k];
}

/// What lies in a tile of the source.
struct SourceTile {
    const std::int32_t* thickness;
    const film::PaintCell* paint;
    const std::int32_t* lower_thickness;
    const film::PaintCell* lower_paint;
    const std::int32_t* worked_thickness;
    decltype(std::declval<const Heights&>().read(0)) relief_mm;
    const std::int32_t* soluble_thickness;
    const film::PigmentCell* soluble_pigment;
    const film::StrataOptics* optics;
    const film::PigmentMixture* uppermost;
};

SourceTile source_tile(const FilmState& layer, int tile) {
    const film::Strata& strata = layer.strata;
    return {layer.thickness.read(tile),
            layer.paint.read(tile),
            layer.lower.thickness.read(tile),
            layer.lower.paint.read(tile),
            layer.worked.thickness.read(tile),
            layer.support_mm.read(tile),
            strata.soluble_thickness.read(tile),
            strata.soluble_pigment.read(tile),
            strata.optics.read(tile),
            strata.uppermost.read(tile)};
}

void add(const SourceTile& source, int cell, double share, CellSum& sum) {
    sum.thickness += share * source.thickness[cell];
    add_shares(source.paint[cell], share, sum.paint);
    if (source.lower_thickness[cell] > 0) {
        sum.any_upper = true;
        sum.upper_thickness += share * (source.thickness[cell] - source.lower_thickness[cell]);
        add_shares(film::upper_paint(source.lower_paint[cell], source.paint[cell]), share,
                   sum.upper_paint);
    }
    sum.worked_thickness += share * source.worked_thickness[cell];
    sum.relief_mm += share * source.relief_mm[cell];
    sum.soluble_thickness += share * source.soluble_thickness[cell];
    add_shares(source.soluble_pigment[cell], share, sum.soluble_pigment);
    add_shares(source.optics[cell], share, sum.optics);
    sum.covered += share;
    if (share <= sum.largest) return;
    sum.largest = share;
    sum.uppermost = source.uppermost[cell];
}

/// All that a tile of the result holds.
struct ResultTile {
    TileBlock<std::int32_t> thickness = TileBlock<std::int32_t>::filled(0);
    TileBlock<film::PaintCell> paint = TileBlock<film::PaintCell>::filled({});
    film::LowerTile lower;
    TileBlock<std::int32_t> worked = TileBlock<std::int32_t>::filled(0);
    TileBlock<film::MediaCell> media;  ///< of a layer of several
    TileBlock<float> relief_mm = TileBlock<float>::filled(0.0F);
    TileBlock<std::int32_t> soluble_thickness = TileBlock<std::int32_t>::filled(0);
    TileBlock<film::PigmentCell> soluble_pigment = TileBlock<film::PigmentCell>::filled({});
    TileBlock<film::StrataOptics> optics = TileBlock<film::StrataOptics>::filled(film::kClearStrata);
    TileBlock<film::PigmentMixture> uppermost = TileBlock<film::PigmentMixture>::filled({});
    bool any_wet = false, any_relief = false, any_soluble = false, any_fixed = false;
};

template <class Values, class Sums>
void round_to(const Sums& sums, Values& values) {
    for (std::size_t k = 0; k < sums.size(); ++k)
        values[k] = static_cast<typename Values::value_type>(std::lround(sums[k]));
}

float relief_of(double sum_mm) {
    return static_cast<float>(std::round(sum_mm / film::kSupportQuantum_mm) * film::kSupportQuantum_mm);
}

/// Where nothing lies, light passes.
void add_clear(double share, CellSum& sum) {
    add_shares(film::kClearStrata, share, sum.optics);
}

/// Paint that was one comes to lie below.
void put_strata(const CellSum& sum, int cell, ResultTile& tile) {
    const std::int32_t thickness = tile.thickness.read()[cell];
    const film::PaintCell& paint = tile.paint.read()[cell];
    film::PaintCell upper{};
    round_to(sum.upper_paint, upper);
    const film::LowerCell lower{thickness - static_cast<std::int32_t>(std::lround(sum.upper_thickness)),
                                film::upper_paint(upper, paint)};
    if (film::is_part_of(lower, thickness, paint) && lower.thickness > 0) tile.lower.set(cell, lower);
}

void put(const CellSum& sum, int cell, ResultTile& tile) {
    const auto thickness = static_cast<std::int32_t>(std::lround(sum.thickness));
    if (thickness > 0) {
        tile.thickness.write()[cell] = thickness;
        round_to(sum.paint, tile.paint.write()[cell]);
        if (sum.any_upper) put_strata(sum, cell, tile);
        tile.worked.write()[cell] = static_cast<std::int32_t>(std::lround(sum.worked_thickness));
        if (tile.media) round_to(sum.media, tile.media.write()[cell]);
        tile.any_wet = true;
    }
    tile.relief_mm.write()[cell] = relief_of(sum.relief_mm);
    tile.any_relief = tile.any_relief || tile.relief_mm.read()[cell] != 0.0F;
    tile.soluble_thickness.write()[cell] = static_cast<std::int32_t>(std::lround(sum.soluble_thickness));
    round_to(sum.soluble_pigment, tile.soluble_pigment.write()[cell]);
    tile.any_soluble = tile.any_soluble || !film::is_empty(tile.soluble_pigment.read()[cell],
                                                           tile.soluble_thickness.read()[cell]);
    round_to(sum.optics, tile.optics.write()[cell]);
    if (tile.optics.read()[cell] == film::kClearStrata) return;
    tile.uppermost.write()[cell] = sum.uppermost;
    tile.any_fixed = true;
}

/// Gives back the memory of what the tile has nothing of.
void drop_bare(ResultTile& tile) {
    if (!tile.any_wet) {
        tile.thickness = {};
        tile.paint = {};
    }
    if (!tile.any_relief) tile.relief_mm = {};
    if (!tile.any_soluble) {
        tile.soluble_thickness = {};
        tile.soluble_pigment = {};
    }
    if (tile.any_fixed) return;
    tile.optics = {};
    tile.uppermost = {};
}

/// The tiles of the source that hold something, and the rectangle of cells around them.
struct Painted {
    std::vector<bool> tiles;
    grid::Rect cells;
};
Painted painted(const FilmState& layer) {
    Painted found{std::vector<bool>(static_cast<std::size_t>(layer.shape.tile_count())), {}};
    for (int tile = 0; tile < layer.shape.tile_count(); ++tile) {
        found.tiles[static_cast<std::size_t>(tile)] = holds_paint(layer, tile);
        if (found.tiles[static_cast<std::size_t>(tile)])
            found.cells = grid::bounding_box(found.cells, layer.shape.tile_cells(tile));
    }
    return found;
}

/// The cells that a rectangle may come to, with those that the footprints reach beyond. What reaches
/// behind the eye comes to lie anywhere.
grid::Rect reached(const grid::Rect& cells, const Projective& map) {
    constexpr double kNearest = 1e-3;
    grid::Point low{1e6, 1e6}, high{-1e6, -1e6};
    double beyond = 0.0;
    for (const auto& [x, y] : {std::pair{cells.x0, cells.y0}, std::pair{cells.x1, cells.y0},
                               std::pair{cells.x0, cells.y1}, std::pair{cells.x1, cells.y1}}) {
        if (map.depth(x, y) < kNearest) return kAnywhere;
        const grid::Point corner = map(x, y);
        const Steps steps = steps_at(map, x, y);
        low = {std::min(low.x, corner.x), std::min(low.y, corner.y)};
        high = {std::max(high.x, corner.x), std::max(high.y, corner.y)};
        beyond = std::max(
            {beyond, std::hypot(steps.right.x, steps.right.y), std::hypot(steps.down.x, steps.down.y)});
    }
    beyond += 1.0;
    const auto cell = [](double place) { return static_cast<int>(std::clamp(place, -1e6, 1e6)); };
    return {cell(std::floor(low.x - beyond)), cell(std::floor(low.y - beyond)),
            cell(std::ceil(high.x + beyond)), cell(std::ceil(high.y + beyond))};
}

/// The cell that a share is of: beyond the canvas the outermost one, or none.
struct CellPlace {
    int x, y;
};
std::optional<CellPlace> place_of(const CellShare& share, const grid::Shape& shape, Beyond beyond) {
    if (shape.contains(share.x, share.y)) return CellPlace{share.x, share.y};
    if (beyond == Beyond::Bare) return std::nullopt;
    return CellPlace{std::clamp(share.x, 0, shape.width - 1), std::clamp(share.y, 0, shape.height - 1)};
}

class Resampler {
  public:
    Resampler(const FilmState& layer, const Resampling& resampling)
        : layer_(layer), painted_(painted(layer)), resampling_(resampling) {}

    const grid::Rect& painted_cells() const { return painted_.cells; }

    ResultTile tile(int tile) const {
        ResultTile result;
        if (layer_.media.are_several()) result.media = TileBlock<film::MediaCell>::filled({});
        Footprint footprint(inverse(resampling_.map),
                            resampling_.beyond == Beyond::Bare ? painted_.cells : kAnywhere);
        const grid::Rect cells = resampling_.shape.tile_cells(tile);
        for (int y = cells.y0; y < cells.y1; ++y)
            for (int x = cells.x0; x < cells.x1; ++x) {
                CellSum sum = sum_of(footprint.of(x, y));
                if (sum.covered == 0.0) continue;
                add_clear(std::max(0.0, 1.0 - sum.covered), sum);
                put(sum, grid::Shape::cell_in_tile(x, y), result);
            }
        drop_bare(result);
        return result;
    }

  private:
    CellSum sum_of(const std::vector<CellShare>& shares) const {
        CellSum sum;
        for (const CellShare& share : shares) {
            const auto place = place_of(share, layer_.shape, resampling_.beyond);
            if (!place) continue;
            const int tile = layer_.shape.tile_at(place->x, place->y);
            if (!painted_.tiles[static_cast<std::size_t>(tile)]) continue;
            const int cell = grid::Shape::cell_in_tile(place->x, place->y);
            add(source_tile(layer_, tile), cell, share.share, sum);
            if (layer_.media.are_several())
                add_shares(film::media_in(layer_, tile, cell), share.share, sum.media);
        }
        return sum;
    }

    const FilmState& layer_;
    Painted painted_;
    const Resampling& resampling_;
};

void commit(int tile, ResultTile& from, FilmState& layer) {
    if (from.any_wet) {
        layer.thickness.replace(tile, std::move(from.thickness));
        layer.paint.replace(tile, std::move(from.paint));
        from.lower.put_into(layer.lower, tile);
        layer.worked.replace(tile, std::move(from.worked));
        if (from.media) film::set_media(layer, tile, std::move(from.media));
    }
    if (from.any_relief) layer.support_mm.replace(tile, std::move(from.relief_mm));
    if (from.any_soluble)
        film::replace_soluble(tile, true, std::move(from.soluble_thickness),
                              std::move(from.soluble_pigment), layer.strata);
    if (!from.any_fixed) return;
    layer.strata.optics.replace(tile, std::move(from.optics));
    layer.strata.uppermost.replace(tile, std::move(from.uppermost));
}

std::vector<int> tiles_in(grid::Shape shape, const grid::Rect& cells) {
    const grid::Rect range = shape.tiles_touching(cells);
    std::vector<int> tiles;
    for (int y = range.y0; y < range.y1; ++y)
        for (int x = range.x0; x < range.x1; ++x)
            tiles.push_back(y * shape.tiles_x() + x);
    return tiles;
}

/// The same volume, told in other cells.
std::int64_t in_other_cells(std::int64_t quanta, double cell_mm, double other_cell_mm) {
    if (cell_mm == other_cell_mm) return quanta;
    const double side = cell_mm / other_cell_mm;
    return std::llround(static_cast<double>(quanta) * side * side);
}

}  // namespace

FilmState resampled(const FilmState& layer, const Resampling& resampling, core::ThreadPool& pool) {
    const Resampler resampler(layer, resampling);
    FilmState result(resampling.shape, resampling.cell_mm);
    result.consistencies = layer.consistencies;
    result.media.numbers = layer.media.numbers;
    if (!resampler.painted_cells().empty()) {
        const std::vector<int> tiles =
            tiles_in(resampling.shape, reached(resampler.painted_cells(), resampling.map));
        std::vector<std::optional<ResultTile>> results(tiles.size());
        pool.run(tiles.size(),
                 [&](std::size_t index, int) { results[index] = resampler.tile(tiles[index]); });
        for (std::size_t index = 0; index < tiles.size(); ++index)
            commit(tiles[index], *results[index], result);
    }
    result.strata.fixed =
        share_fixed(layer.strata.fixed, fixed_relief_quanta(result), fixed_relief_quanta(layer));
    result.strata.evaporated =
        in_other_cells(layer.strata.evaporated, layer.cell_mm, resampling.cell_mm);
    return result;
}

grid::Mask resampled(const grid::Mask& mask, const Resampling& resampling) {
    const Projective to_source = inverse(resampling.map);
    grid::MaskBuilder builder(resampling.shape);
    const auto cell = [](double place) {
        return static_cast<int>(std::floor(std::clamp(place, -1e6, 1e6)));
    };
    for (int tile = 0; tile < resampling.shape.tile_count(); ++tile) {
        std::array<std::uint8_t, kTileCells> chosen{};
        const grid::Rect cells = resampling.shape.tile_cells(tile);
        for (int y = cells.y0; y < cells.y1; ++y)
            for (int x = cells.x0; x < cells.x1; ++x) {
                if (!comes_from_somewhere(to_source, x, y)) continue;
                const grid::Point from = to_source(x + 0.5, y + 0.5);
                const auto place =
                    place_of({cell(from.x), cell(from.y), 1.0}, mask.shape(), resampling.beyond);
                if (place) chosen[grid::Shape::cell_in_tile(x, y)] = mask.at(place->x, place->y);
            }
        builder.set_tile(tile, chosen.data());
    }
    return builder.take();
}

Heights resampled(const Heights& heights_mm, const Resampling& resampling, core::ThreadPool& pool) {
    Heights result(resampling.shape);
    pool.run(static_cast<std::size_t>(resampling.shape.tile_count()), [&](std::size_t index, int) {
        const int tile = static_cast<int>(index);
        Footprint footprint(inverse(resampling.map));
        auto block = TileBlock<float>::filled(0.0F);
        float* values_mm = block.write();
        const grid::Rect cells = resampling.shape.tile_cells(tile);
        for (int y = cells.y0; y < cells.y1; ++y)
            for (int x = cells.x0; x < cells.x1; ++x) {
                double sum_mm = 0.0;
                for (const CellShare& share : footprint.of(x, y)) {
                    const auto place = place_of(share, heights_mm.shape(), Beyond::GoesOn);
                    sum_mm += share.share * heights_mm.at(place->x, place->y);
                }
                values_mm[grid::Shape::cell_in_tile(x, y)] = relief_of(sum_mm);
            }
        result.replace(tile, film::HeightBlock::smallest_of(std::move(block)));
    });
    return result;
}

}  // namespace pastoso::layers
