#include "layers/view.hpp"

#include "core/check.hpp"
#include "layers/apart.hpp"
#include "pigment/layer_optics.hpp"

#include <utility>

namespace pastoso::layers {
namespace {

using film::FilmState;
using film::StrataOptics;
using grid::kTileCells;
using grid::TileBlock;

/// The layers' optics are kept in floats here: rounding to 65535ths comes once.
using Light = std::array<pigment::LayerOptics<float>, pigment::kBands>;

/// One cell of a layer or of several.
struct Cell {
    const std::int32_t thickness;
    const film::PaintCell& paint;
    const film::PaintCell& wet_below;
    const film::PigmentCell& soluble;
    const StrataOptics& optics;
};

struct Tile {
    explicit Tile(const FilmState& film, int tile)
        : thickness(film.thickness.read(tile)),
          paint(film.paint.read(tile)),
          below_thickness(film.lower.thickness.read(tile)),
          wet_below(film.lower.paint.read(tile)),
          support_mm(film.support_mm.read(tile)),
          soluble_thickness(film.strata.soluble_thickness.read(tile)),
          soluble(film.strata.soluble_pigment.read(tile)),
          optics(film.strata.optics.read(tile)),
          uppermost(film.strata.uppermost.read(tile)) {}

    Cell operator[](int cell) const {
        return {thickness[cell], paint[cell], wet_below[cell], soluble[cell], optics[cell]};
    }
    bool is_dry_in(int cell) const {
        return support_mm[cell] != 0.0F || optics[cell] != film::kClearStrata ||
               !film::is_empty(soluble[cell], soluble_thickness[cell]);
    }

    const std::int32_t* thickness;
    const film::PaintCell* paint;
    const std::int32_t* below_thickness;  ///< of the lower wet stratum
    const film::PaintCell* wet_below;
    film::TileHeights support_mm;
    const std::int32_t* soluble_thickness;
    const film::PigmentCell* soluble;
    const StrataOptics* optics;
    const film::PigmentMixture* uppermost;
};

void lay_pigment(const std::int32_t* pigment, Light& light) {
    for (int band = 0; band < pigment::kBands; ++band) {
        const auto layer =
            pigment::layer_optics(film::optical_thickness(pigment[band]),
                                  film::optical_thickness(pigment[band + pigment::kBands]));
        light[band] = pigment::laid_over(layer, light[band]);
    }
}

void lay_wet(const Cell& cell, Light& light) {
    if (cell.wet_below == film::PaintCell{}) return lay_pigment(cell.paint.data(), light);
    lay_pigment(cell.wet_below.data(), light);
    lay_pigment(film::upper_paint(cell.wet_below, cell.paint).data(), light);
}

/// What all of a cell does to light.
Light light_of(const Cell& cell) {
    Light light;
    for (int band = 0; band < pigment::kBands; ++band)
        light[band] = film::optics_of(cell.optics, band);
    lay_pigment(cell.soluble.data(), light);
    lay_wet(cell, light);
    return light;
}

StrataOptics codes_of(const Light& light) {
    StrataOptics strata{};
    for (int band = 0; band < pigment::kBands; ++band)
        film::set_optics(band, light[band], strata);
    return strata;
}

Light faded_over(const Light& upper, double opacity, const Light& lower) {
    Light light;
    for (int band = 0; band < pigment::kBands; ++band)
        light[band] =
            pigment::laid_over(pigment::faded(upper[band], static_cast<float>(opacity)), lower[band]);
    return light;
}

/// What is made of a tile in which both layers hold something.
struct SeenTile {
    TileBlock<std::int32_t> thickness = TileBlock<std::int32_t>::uninitialised();
    TileBlock<film::PaintCell> paint = TileBlock<film::PaintCell>::uninitialised();
    film::LowerTile wet_below;
    TileBlock<float> support_mm = TileBlock<float>::uninitialised();
    TileBlock<std::int32_t> soluble_thickness = TileBlock<std::int32_t>::uninitialised();
    TileBlock<film::PigmentCell> soluble = TileBlock<film::PigmentCell>::uninitialised();
    TileBlock<StrataOptics> optics = TileBlock<StrataOptics>::uninitialised();
    TileBlock<film::PigmentMixture> uppermost = TileBlock<film::PigmentMixture>::uninitialised();

    void take(const Tile& from, int cell) {
        thickness.write()[cell] = from.thickness[cell];
        paint.write()[cell] = from.paint[cell];
        take_wet_below(from, cell);
        support_mm.write()[cell] = from.support_mm[cell];
        soluble_thickness.write()[cell] = from.soluble_thickness[cell];
        soluble.write()[cell] = from.soluble[cell];
        optics.write()[cell] = from.optics[cell];
        uppermost.write()[cell] = from.uppermost[cell];
    }
    void take_wet_below(const Tile& from, int cell) {
        wet_below.set(cell, {from.below_thickness[cell], from.wet_below[cell]});
    }
};

/// Of the uppermost wet paint that nothing dry covers; it lies at the top of all heights.
std::int32_t shining_thickness(const Tile& upper, const Tile& lower, int cell) {
    if (upper.thickness[cell] > 0) return upper.thickness[cell];
    return upper.is_dry_in(cell) ? 0 : lower.thickness[cell];
}

/// An opaque layer: its wet paint and what can be dissolved stay what they are.
void lay_opaque(const Tile& upper, const Tile& lower, int cell, SeenTile& seen) {
    seen.paint.write()[cell] = upper.paint[cell];
    seen.take_wet_below(upper, cell);
    seen.soluble_thickness.write()[cell] = upper.soluble_thickness[cell];
    seen.soluble.write()[cell] = upper.soluble[cell];
    Light fixed;
    for (int band = 0; band < pigment::kBands; ++band)
        fixed[band] = film::optics_of(upper.optics[cell], band);
    seen.optics.write()[cell] = codes_of(faded_over(fixed, 1.0, light_of(lower[cell])));
}

void lay_faded(const Tile& upper, double opacity, const Tile& lower, int cell, SeenTile& seen) {
    seen.paint.write()[cell] = {};
    seen.soluble_thickness.write()[cell] = 0;
    seen.soluble.write()[cell] = {};
    seen.optics.write()[cell] =
        codes_of(faded_over(light_of(upper[cell]), opacity, light_of(lower[cell])));
}

bool is_empty_in(const Tile& tile, int cell) {
    return tile.thickness[cell] == 0 && !tile.is_dry_in(cell);
}

void lay_cell_over(const Tile& upper, double opacity, const Tile& lower, int cell, SeenTile& seen) {
    if (is_empty_in(upper, cell)) return seen.take(lower, cell);
    if (opacity == 1.0)
        lay_opaque(upper, lower, cell, seen);
    else
        lay_faded(upper, opacity, lower, cell, seen);
    const bool sealed = upper.optics[cell] != film::kClearStrata;
    seen.uppermost.write()[cell] = sealed ? upper.uppermost[cell] : lower.uppermost[cell];
    const std::int32_t shining = shining_thickness(upper, lower, cell);
    seen.thickness.write()[cell] = shining;
    seen.support_mm.write()[cell] = lower.support_mm[cell] + wet_height_mm(lower.thickness[cell]) +
                                    upper.support_mm[cell] + wet_height_mm(upper.thickness[cell]) -
                                    wet_height_mm(shining);
}

void commit(SeenTile seen, int tile, FilmState& result) {
    result.thickness.replace(tile, std::move(seen.thickness));
    result.paint.replace(tile, std::move(seen.paint));
    seen.wet_below.put_into(result.lower, tile);
    result.support_mm.replace(tile, std::move(seen.support_mm));
    result.strata.soluble_thickness.replace(tile, std::move(seen.soluble_thickness));
    result.strata.soluble_pigment.replace(tile, std::move(seen.soluble));
    result.strata.optics.replace(tile, std::move(seen.optics));
    result.strata.uppermost.replace(tile, std::move(seen.uppermost));
}

void share_paint(const FilmState& from, int tile, FilmState& to) {
    share_tile(from.thickness, tile, to.thickness);
    share_tile(from.paint, tile, to.paint);
    share_tile(from.lower.thickness, tile, to.lower.thickness);
    share_tile(from.lower.paint, tile, to.lower.paint);
    share_tile(from.strata.soluble_thickness, tile, to.strata.soluble_thickness);
    share_tile(from.strata.soluble_pigment, tile, to.strata.soluble_pigment);
}

void share_strata(const FilmState& from, int tile, FilmState& to) {
    share_tile(from.strata.optics, tile, to.strata.optics);
    share_tile(from.strata.uppermost, tile, to.strata.uppermost);
}

void sum_heights(const FilmState& upper, const FilmState& lower, int tile, FilmState& result) {
    share_tile(lower.support_mm, tile, result.support_mm);
    if (upper.support_mm.is_background(tile)) return;
    float* heights = result.support_mm.write(tile);
    const film::TileHeights relief = upper.support_mm.read(tile);
    for (int cell = 0; cell < kTileCells; ++cell)
        heights[cell] += relief[cell];
}

/// Whether all that the lower layers hold in the tile is fixed, and so stays below whatever comes on
/// top.
bool is_fixed_in(const FilmState& lower, int tile) {
    return lower.thickness.is_background(tile) && lower.strata.soluble_pigment.is_background(tile) &&
           lower.strata.soluble_thickness.is_background(tile);
}

}  // namespace

void lay_tile_over(const SeenLayer& upper, const FilmState& lower, int tile, FilmState& result) {
    const FilmState& layer = *upper.film;
    if (!holds_paint(layer, tile)) {
        share_paint(lower, tile, result);
        share_strata(lower, tile, result);
        share_tile(lower.support_mm, tile, result.support_mm);
        return;
    }
    const bool below_is_clear = lower.strata.optics.is_background(tile);
    const bool layer_is_clear = layer.strata.optics.is_background(tile);
    if (upper.opacity == 1.0 && is_fixed_in(lower, tile) && (below_is_clear || layer_is_clear)) {
        share_paint(layer, tile, result);
        share_strata(layer_is_clear ? lower : layer, tile, result);
        sum_heights(layer, lower, tile, result);
        return;
    }
    SeenTile seen;
    const Tile above(layer, tile), below(lower, tile);
    for (int cell = 0; cell < kTileCells; ++cell)
        lay_cell_over(above, upper.opacity, below, cell, seen);
    commit(std::move(seen), tile, result);
}

FilmState View::of(const FilmState& bare, const std::vector<SeenLayer>& layers, core::ThreadPool& pool) {
    steps_.resize(layers.size());
    const FilmState* below = &bare;
    for (std::size_t i = 0; i < layers.size(); ++i) {
        Step& step = steps_[i];
        const SeenLayer& layer = layers[i];
        if (layer.onto == nullptr)
            step.clipper.reset();
        else if (!step.clipper)
            step.clipper.emplace();
        const FilmState& shown =
            step.clipper ? step.clipper->shown(*layer.film, *layer.onto) : *layer.film;
        look({&shown, layer.opacity}, *below, step, pool);
        below = &step.result;
    }
    FilmState seen = *below;
    if (!layers.empty()) seen.consistencies = layers.back().film->consistencies;
    return seen;
}

void View::look(const SeenLayer& layer, const FilmState& below, Step& step, core::ThreadPool& pool) {
    PASTOSO_CHECK(layer.film->shape == below.shape);
    const bool afresh = step.result.shape != below.shape || step.opacity != layer.opacity;
    if (step.result.shape != below.shape) step.result = FilmState(below.shape, below.cell_mm);
    std::vector<int> changed;
    for (int tile = 0; tile < below.shape.tile_count(); ++tile) {
        if (afresh || !looks_same(*layer.film, step.layer, tile) || !looks_same(below, step.below, tile))
            changed.push_back(tile);
    }
    pool.run(changed.size(),
             [&](std::size_t index, int) { lay_tile_over(layer, below, changed[index], step.result); });
    if (changed.empty()) return;
    step.layer = *layer.film;
    step.below = below;
    step.opacity = layer.opacity;
}

}  // namespace pastoso::layers
