#include "document/similar_colour.hpp"

#include "brush/nearest_cell.hpp"
#include "grid/connected.hpp"
#include "pigment/appearance.hpp"
#include "pigment/lab.hpp"
#include "shade/tile_colour.hpp"

#include <array>
#include <utility>
#include <vector>

namespace pastoso::document {
namespace {

using TileMask = std::array<std::uint8_t, grid::kTileCells>;
using TileColours = std::vector<shade::CellColour>;

pigment::Lab lab_of(const shade::CellColour& cell) {
    return pigment::lab(pigment::screen_colour({cell.red, cell.green, cell.blue}));
}

bool is_same(const shade::CellColour& a, const shade::CellColour& b) {
    return a.red == b.red && a.green == b.green && a.blue == b.blue;
}

/// Cells of a bare ground are all of one colour: neighbours are compared before a difference is worked
/// out.
TileMask similar_cells(const TileColours& colours, const pigment::Lab& wanted, double difference) {
    TileMask chosen;
    for (int cell = 0; cell < grid::kTileCells; ++cell) {
        const bool as_before = cell > 0 && is_same(colours[cell], colours[cell - 1]);
        if (as_before)
            chosen[cell] = chosen[cell - 1];
        else
            chosen[cell] =
                pigment::ciede2000(lab_of(colours[cell]), wanted) <= difference ? grid::kWhole : 0;
    }
    return chosen;
}

TileColours colours_of(const film::FilmState& seen, int tile, const pigment::Bands& ground) {
    TileColours colours(grid::kTileCells);
    shade::tile_colours(seen, tile, ground, colours.data());
    return colours;
}

grid::Mask similar_everywhere(const film::FilmState& seen, const pigment::Bands& ground,
                              const pigment::Lab& wanted, double difference, core::ThreadPool& pool) {
    std::vector<TileMask> tiles(static_cast<std::size_t>(seen.shape.tile_count()));
    pool.run(tiles.size(), [&](std::size_t tile, int) {
        tiles[tile] =
            similar_cells(colours_of(seen, static_cast<int>(tile), ground), wanted, difference);
    });
    grid::MaskBuilder builder(seen.shape);
    for (int tile = 0; tile < seen.shape.tile_count(); ++tile)
        builder.set_tile(tile, tiles[static_cast<std::size_t>(tile)].data());
    return builder.take();
}

}  // namespace

grid::Mask area_of(const SelectSimilarColour& select, const film::FilmState& seen,
                   const pigment::Bands& ground, core::ThreadPool& pool) {
    const auto [x, y] = brush::nearest_cell(seen, select.x_mm, select.y_mm);
    const TileColours there = colours_of(seen, seen.shape.tile_at(x, y), ground);
    const pigment::Lab wanted = lab_of(there[grid::Shape::cell_in_tile(x, y)]);
    grid::Mask similar = similar_everywhere(seen, ground, wanted, select.difference, pool);
    return select.connected ? grid::connected(similar, x, y) : similar;
}

}  // namespace pastoso::document
