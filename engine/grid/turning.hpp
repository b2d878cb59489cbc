// Fields on a canvas that has been turned or mirrored as a whole.
#pragma once

#include "core/orientation.hpp"
#include "core/thread_pool.hpp"
#include "grid/tiled_field.hpp"

#include <algorithm>
#include <cstddef>
#include <vector>

namespace pastoso::grid {

inline Shape turned(const Shape& shape, const core::Orientation& turn) {
    return turn.swaps_sides() ? Shape{shape.height, shape.width} : shape;
}

/// The canvas before it was turned, as its tiles of now see it.
class TilesBefore {
  public:
    TilesBefore(const Shape& before, const core::Orientation& turn)
        : before_(before), after_(turned(before, turn)), cells_(turn, before.width, before.height) {}

    const Shape& after() const { return after_; }
    const core::CellsBefore& cells() const { return cells_; }

    /// The cells that were those of a tile of now.
    Rect cells_of(int tile) const {
        const Rect now = after_.tile_cells(tile);
        const auto first = cells_(now.x0, now.y0), last = cells_(now.x1 - 1, now.y1 - 1);
        return {std::min(first.x, last.x), std::min(first.y, last.y), std::max(first.x, last.x) + 1,
                std::max(first.y, last.y) + 1};
    }

    /// Whether any tile that cells of a tile of now were in is `such_a(tile before)`.
    template <class Predicate>
    bool any_of(int tile, const Predicate& such_a) const {
        const Rect tiles = before_.tiles_touching(cells_of(tile));
        for (int y = tiles.y0; y < tiles.y1; ++y)
            for (int x = tiles.x0; x < tiles.x1; ++x)
                if (such_a(y * before_.tiles_x() + x)) return true;
        return false;
    }

    /// Calls visit(cell in its tile, tile before, cell in that) for all cells of a tile of now.
    template <class Visit>
    void for_each_cell(int tile, const Visit& visit) const {
        const Rect now = after_.tile_cells(tile);
        for (int y = now.y0; y < now.y1; ++y)
            for (int x = now.x0; x < now.x1; ++x) {
                const auto from = cells_(x, y);
                visit(Shape::cell_in_tile(x, y), before_.tile_at(from.x, from.y),
                      Shape::cell_in_tile(from.x, from.y));
            }
    }

  private:
    Shape before_, after_;
    core::CellsBefore cells_;
};

/// Puts the values of `field` where they come to lie into `result`, a field of the turned shape that is
/// background all over. Either may be any field with the members of TiledField.
template <class Field>
void put_turned(const Field& field, const core::Orientation& turn, Field& result,
                core::ThreadPool& pool) {
    const TilesBefore before(field.shape(), turn);
    PASTOSO_CHECK(result.shape() == before.after());
    pool.run(static_cast<std::size_t>(result.tile_count()), [&](std::size_t index, int) {
        const int tile = static_cast<int>(index);
        if (!before.any_of(tile, [&](int source) { return !field.is_background(source); })) return;
        auto* values = result.write(tile);
        before.for_each_cell(tile, [&](int cell, int source, int source_cell) {
            values[cell] = field.read(source)[source_cell];
        });
    });
}

/// Which tiles of now have cells of such tiles before.
inline std::vector<bool> turned_tiles(const std::vector<bool>& tiles, const Shape& shape,
                                      const core::Orientation& turn) {
    const TilesBefore before(shape, turn);
    std::vector<bool> now(tiles.size());
    for (std::size_t tile = 0; tile < now.size(); ++tile)
        now[tile] = before.any_of(static_cast<int>(tile), [&](int source) { return tiles[source]; });
    return now;
}

}  // namespace pastoso::grid
