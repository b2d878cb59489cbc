#include "shade/tile_colour.hpp"

#include "shade/cell_span.hpp"
#include "shade/kernels.hpp"

namespace pastoso::shade {

void tile_colours(const film::FilmState& film, int tile, const pigment::Bands& ground, CellColour* out) {
    kernels(core::best_isa())
        .colour_cells(film.paint.read(tile), film.thickness.read(tile), grid::kTileCells, ground, out);
}

void cell_colours(const film::FilmState& film, const grid::Rect& cells, const pigment::Bands& ground,
                  CellColour* out, int stride) {
    const Kernels& kernel = kernels(core::best_isa());
    const auto fill = [&](const grid::Rect& part, CellColour* target, int target_stride) {
        gather_cells(film.shape, part, target, target_stride,
                     [&](int tile, int cell, int count, CellColour* to) {
                         kernel.colour_cells(film.paint.read(tile) + cell,
                                             film.thickness.read(tile) + cell, count, ground, to);
                     });
    };
    fill_beyond_edges(film.shape, cells, out, stride, fill);
}

}  // namespace pastoso::shade
