#include "layers/dry_cells.hpp"

#include <utility>

namespace pastoso::layers {
namespace {

void copy_dry(const film::FilmState& from, int tile, int cell, film::FilmState& to, int place) {
    const film::Strata& strata = from.strata;
    to.support_mm.write(0)[place] = from.support_mm.read(tile)[cell];
    to.strata.soluble_thickness.write(0)[place] = strata.soluble_thickness.read(tile)[cell];
    to.strata.soluble_pigment.write(0)[place] = strata.soluble_pigment.read(tile)[cell];
    to.strata.optics.write(0)[place] = strata.optics.read(tile)[cell];
    to.strata.uppermost.write(0)[place] = strata.uppermost.read(tile)[cell];
}

}  // namespace

bool any_dry_cell(const film::FilmState& layer) {
    bool any = false;
    for (int tile = 0; tile < layer.shape.tile_count() && !any; ++tile)
        for_each_dry_cell(layer, nullptr, tile, [&](int, std::uint8_t) { any = true; });
    return any;
}

std::int64_t dry_cell_count(const film::FilmState& layer, const grid::Mask* where) {
    std::int64_t count = 0;
    for (int tile = 0; tile < layer.shape.tile_count(); ++tile)
        for_each_dry_cell(layer, where, tile, [&](int, std::uint8_t) { ++count; });
    return count;
}

DrySample dry_sample(const film::FilmState& layer, const grid::Mask* where) {
    constexpr grid::Shape kOneTile{grid::kTileSize, grid::kTileSize};
    DrySample sample{.film = film::FilmState(kOneTile, layer.cell_mm)};
    const std::int64_t apart = (dry_cell_count(layer, where) + grid::kTileCells - 1) / grid::kTileCells;
    std::int64_t passed = 0;
    for (int tile = 0; tile < layer.shape.tile_count(); ++tile)
        for_each_dry_cell(layer, where, tile, [&](int cell, std::uint8_t) {
            if (passed++ % apart == 0) copy_dry(layer, tile, cell, sample.film, sample.count++);
        });
    return sample;
}

}  // namespace pastoso::layers
