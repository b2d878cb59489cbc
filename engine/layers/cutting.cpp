#include "layers/cutting.hpp"

#include "core/check.hpp"
#include "layers/apart.hpp"
#include "layers/cell_share.hpp"

#include <cmath>

namespace pastoso::layers {
namespace {

using film::FilmState;
using grid::kTileCells;

/// Sets the cells of a tile to `nothing` that `is_left` does not name.
template <class T, class IsLeft>
void keep_cells(const IsLeft& is_left, int tile, const T& nothing, grid::TiledField<T>& field) {
    if (field.is_background(tile)) return;
    T* values = field.write(tile);
    for (int cell = 0; cell < kTileCells; ++cell)
        if (!is_left(cell)) values[cell] = nothing;
}

template <class IsLeft>
void keep_relief(const IsLeft& is_left, int tile, Heights& relief_mm) {
    if (relief_mm.is_background(tile)) return;
    float* heights = relief_mm.write(tile);
    for (int cell = 0; cell < kTileCells; ++cell)
        if (!is_left(cell)) heights[cell] = 0.0F;
}

template <class IsLeft>
void keep_paint(const IsLeft& is_left, int tile, FilmState& layer) {
    keep_cells(is_left, tile, std::int32_t{0}, layer.thickness);
    keep_cells(is_left, tile, film::PaintCell{}, layer.paint);
    keep_cells(is_left, tile, std::int32_t{0}, layer.lower.thickness);
    keep_cells(is_left, tile, film::PaintCell{}, layer.lower.paint);
    keep_cells(is_left, tile, std::int32_t{0}, layer.worked.thickness);
    keep_cells(is_left, tile, film::MediaCell{}, layer.media.foreign);
    keep_relief(is_left, tile, layer.support_mm);
    keep_cells(is_left, tile, std::int32_t{0}, layer.strata.soluble_thickness);
    keep_cells(is_left, tile, film::PigmentCell{}, layer.strata.soluble_pigment);
    keep_cells(is_left, tile, film::kClearStrata, layer.strata.optics);
    keep_cells(is_left, tile, film::PigmentMixture{}, layer.strata.uppermost);
}

/// Paint beside the border of the mask no longer pushes across it.
void stop_at_border(const grid::Mask& mask, int tile, FilmState& layer) {
    const grid::Rect cells = layer.shape.tile_cells(tile);
    const auto stop = [&](int x, int y, int next_x, int next_y, grid::TiledField<float>& velocity) {
        if (!layer.shape.contains(next_x, next_y) || velocity.at(x, y) == 0.0F) return;
        if (mask.at(x, y) != mask.at(next_x, next_y)) velocity.set(x, y, 0.0F);
    };
    for (int y = cells.y0; y < cells.y1; ++y)
        for (int x = cells.x0; x < cells.x1; ++x) {
            stop(x, y, x + 1, y, layer.velocity_x);
            stop(x, y, x, y + 1, layer.velocity_y);
        }
}

void keep_tile(const FilmState& layer, const grid::Mask& mask, bool chosen, int tile, FilmState& part) {
    const bool all = grid::chooses_all(mask, tile), none = grid::chooses_none(mask, tile);
    if (chosen ? none : all) return;
    take_tile(layer, tile, part);
    if (!all && !none) {
        const std::uint8_t* shares = mask.read(tile);
        const auto is_left = [&](int cell) { return shares[cell] != (chosen ? 0 : grid::kWhole); };
        keep_paint(is_left, tile, part);
        keep_cells(is_left, tile, 0.0F, part.velocity_x);
        keep_cells(is_left, tile, 0.0F, part.velocity_y);
        for (int cell = 0; cell < kTileCells; ++cell)
            if (shares[cell] != 0 && shares[cell] != grid::kWhole)
                keep_share(tile, cell, {shares[cell], !chosen}, part);
    }
    stop_at_border(mask, tile, part);
}

FilmState part_of(const FilmState& layer, const grid::Mask& mask, bool chosen) {
    FilmState part(layer.shape, layer.cell_mm);
    part.consistencies = layer.consistencies;
    part.media.numbers = layer.media.numbers;
    for (int tile = 0; tile < layer.shape.tile_count(); ++tile)
        if (holds_paint(layer, tile)) keep_tile(layer, mask, chosen, tile, part);
    return part;
}

std::int64_t tile_fixed_quanta(const FilmState& layer, int tile) {
    const auto relief = layer.support_mm.read(tile);
    const std::int32_t* soluble = layer.strata.soluble_thickness.read(tile);
    const grid::Rect cells = layer.shape.tile_cells(tile);
    std::int64_t sum = 0;
    for (int y = cells.y0; y < cells.y1; ++y)
        for (int x = cells.x0; x < cells.x1; ++x) {
            const int cell = grid::Shape::cell_in_tile(x, y);
            sum += std::llround(relief[cell] / film::kThicknessQuantum_mm) - soluble[cell];
        }
    return sum;
}

}  // namespace

CutLayer cut(const FilmState& layer, const grid::Mask& mask) {
    PASTOSO_CHECK(mask.shape() == layer.shape);
    CutLayer parts{part_of(layer, mask, true), part_of(layer, mask, false)};
    parts.inside.strata.fixed =
        share_fixed(layer.strata.fixed, fixed_relief_quanta(parts.inside), fixed_relief_quanta(layer));
    parts.outside.strata.fixed = layer.strata.fixed;
    parts.outside.strata.fixed -= parts.inside.strata.fixed;
    parts.outside.strata.evaporated = layer.strata.evaporated;
    return parts;
}

void keep_chosen(const grid::Mask& mask, int tile, FilmState& layer) {
    const std::uint8_t* is_chosen = mask.read(tile);
    keep_paint([&](int cell) { return is_chosen[cell] != 0; }, tile, layer);
}

std::int64_t fixed_relief_quanta(const FilmState& layer) {
    std::int64_t sum = 0;
    for (int tile = 0; tile < layer.shape.tile_count(); ++tile)
        if (holds_paint(layer, tile)) sum += tile_fixed_quanta(layer, tile);
    return sum;
}

film::DriedTotals share_fixed(const film::DriedTotals& fixed, std::int64_t part_quanta,
                              std::int64_t whole_quanta) {
    if (part_quanta == whole_quanta) return fixed;
    if (whole_quanta <= 0) return {};
    const double share = static_cast<double>(part_quanta) / static_cast<double>(whole_quanta);
    film::DriedTotals part;
    part.thickness = std::llround(share * static_cast<double>(fixed.thickness));
    for (std::size_t k = 0; k < part.pigment.size(); ++k)
        part.pigment[k] = std::llround(share * static_cast<double>(fixed.pigment[k]));
    return part;
}

}  // namespace pastoso::layers
