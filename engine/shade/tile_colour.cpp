#include "shade/tile_colour.hpp"

#include "shade/cell_span.hpp"
#include "shade/kernels.hpp"

#include <algorithm>
#include <array>

namespace pastoso::shade {
namespace {

/// The cells of a tile from number `first` on.
CellStack cell_stack(const film::FilmState& film, int tile, int first) {
    const film::Strata& strata = film.strata;
    const bool soluble = !strata.soluble_pigment.is_background(tile);
    const bool fixed = !strata.optics.is_background(tile);
    return {film.paint.read(tile) + first,
            film.lower.is_in(tile) ? film.lower.paint.read(tile) + first : nullptr,
            film.thickness.read(tile) + first,
            soluble ? strata.soluble_pigment.read(tile) + first : nullptr,
            fixed ? strata.optics.read(tile) + first : nullptr};
}

/// The same without the wet paint.
CellStack dry_stack(const film::FilmState& film, int tile, int first) {
    static constexpr std::array<film::PaintCell, grid::kTileCells> kNoPaint{};
    static constexpr std::array<std::int32_t, grid::kTileCells> kNoThickness{};
    CellStack cells = cell_stack(film, tile, first);
    cells.paint = kNoPaint.data();
    cells.lower = nullptr;
    cells.thickness = kNoThickness.data();
    return cells;
}

bool is_bare(const CellStack& cells) {
    return cells.soluble == nullptr && cells.strata == nullptr;
}

}  // namespace

void tile_colours(const film::FilmState& film, int tile, const pigment::Bands& ground, CellColour* out,
                  const pigment::BandsToRgb& to_rgb) {
    core::kernels<Kernels>().colour_cells(cell_stack(film, tile, 0), grid::kTileCells, ground, to_rgb,
                                          out);
}

void cell_colours(const film::FilmState& film, const grid::Rect& cells, const pigment::Bands& ground,
                  CellColour* out, int stride, const pigment::BandsToRgb& to_rgb) {
    const auto& kernel = core::kernels<Kernels>();
    const auto fill = [&](const grid::Rect& part, CellColour* target, int target_stride) {
        gather_cells(film.shape, part, target, target_stride,
                     [&](int tile, int cell, int count, CellColour* to) {
                         kernel.colour_cells(cell_stack(film, tile, cell), count, ground, to_rgb, to);
                     });
    };
    fill_beyond_edges(film.shape, cells, out, stride, fill);
}

void dry_colours(const film::FilmState& film, const grid::Rect& cells, const pigment::Bands& ground,
                 CellColour* out, int stride, const pigment::BandsToRgb& to_rgb) {
    const auto& kernel = core::kernels<Kernels>();
    const auto fill = [&](const grid::Rect& part, CellColour* target, int target_stride) {
        gather_cells(film.shape, part, target, target_stride,
                     [&](int tile, int cell, int count, CellColour* to) {
                         const CellStack cells_below = dry_stack(film, tile, cell);
                         const int apart = is_bare(cells_below) ? 1 : count;
                         kernel.colour_cells(cells_below, apart, ground, to_rgb, to);
                         std::fill(to + apart, to + count, to[0]);
                     });
    };
    fill_beyond_edges(film.shape, cells, out, stride, fill);
}

}  // namespace pastoso::shade
