// A choice of cells.
#pragma once

#include "grid/tiled_field.hpp"

#include <cstdint>
#include <functional>
#include <vector>

namespace pastoso::grid {

/// 1 for every cell that is chosen, 0 for the others. Says of cells beyond the canvas, which the tiles
/// at its edges have, what it likes.
using Mask = TiledField<std::uint8_t>;

/// A point of the canvas in cell units.
struct Point {
    double x = 0.0, y = 0.0;
    friend bool operator==(const Point&, const Point&) = default;
};

/// How a choice changes one that was made before.
enum class Combination { Replace, Add, Subtract, Intersect };

/// The cells whose centres a closed polygon winds around at least once, whichever way: where an outline
/// crosses itself, its loops are in. A centre on an edge belongs to what lies right of it or below it.
/// Fewer than three points enclose nothing. Coordinates are finite.
Mask polygon_mask(Shape shape, const std::vector<Point>& outline);

/// Row by row from the top: `choose_row` sets the cells of row y, all 0 at first and as many as the
/// canvas is wide.
Mask mask_by_rows(Shape shape,
                  const std::function<void(int y, std::vector<std::uint8_t>& chosen)>& choose_row);

/// Of one shape.
Mask combined(const Mask& before, const Mask& region, Combination how);

Mask inverted(const Mask& mask);

/// The cells of the canvas that are chosen.
std::int64_t chosen_cells(const Mask& mask);

/// The smallest rectangle around them; empty where there are none.
Rect chosen_area(const Mask& mask);

/// True when no cell of the tile is chosen, or all are: found without looking at most of them.
bool chooses_none(const Mask& mask, int tile);
bool chooses_all(const Mask& mask, int tile);

/// Bytes of the tiles that are chosen in part; the others share one.
std::size_t bytes_in_part(const Mask& mask);

/// Builds a mask tile by tile: tiles in which all cells are alike share their storage.
class MaskBuilder {
  public:
    explicit MaskBuilder(Shape shape) : mask_(shape) {}
    void set_tile(int tile, const std::uint8_t* chosen);
    Mask take() { return std::move(mask_); }

  private:
    Mask mask_;
    TileBlock<std::uint8_t> all_ = TileBlock<std::uint8_t>::filled(1);
};

}  // namespace pastoso::grid
