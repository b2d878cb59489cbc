// A choice of cells, or of shares of them.
#pragma once

#include "grid/tiled_field.hpp"

#include <cstdint>
#include <functional>
#include <vector>

namespace pastoso::grid {

/// The share of every cell that is chosen, in 255ths: kWhole or 0, and between them along soft edges.
/// Says of cells beyond the canvas, which the tiles at its edges have, what it likes.
using Mask = TiledField<std::uint8_t>;

inline constexpr std::uint8_t kWhole = 255;

/// Whether a cell of that share is chosen, where one is or is not: from one half on.
inline constexpr bool is_chosen(std::uint8_t share) {
    return share > kWhole / 2;
}

/// From 0 to 1.
inline constexpr float fraction_of(std::uint8_t share) {
    return static_cast<float>(share) / kWhole;
}

/// That share of an amount, rounded towards 0.
inline constexpr std::int32_t share_of(std::int32_t amount, std::uint8_t share) {
    return static_cast<std::int32_t>(std::int64_t{amount} * share / kWhole);
}

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

/// Row by row from the top: `choose_row` sets the shares of row y, all 0 at first and as many as the
/// canvas is wide.
Mask mask_by_rows(Shape shape,
                  const std::function<void(int y, std::vector<std::uint8_t>& chosen)>& choose_row);

/// Of one shape. Of the shares, Add takes the larger, Intersect the smaller, Subtract their difference
/// or 0.
Mask combined(const Mask& before, const Mask& region, Combination how);

/// The rest of every cell.
Mask inverted(const Mask& mask);

/// Every cell whole or not at all, as is_chosen() has it.
Mask hardened(const Mask& mask);

/// The number of cells of the canvas that are chosen by half or more.
std::int64_t chosen_cells(const Mask& mask);

/// The smallest rectangle around those that are chosen by any share; empty where there are none.
Rect chosen_area(const Mask& mask);

/// Whether a cell of the canvas is chosen neither whole nor not at all.
bool is_soft(const Mask& mask);

/// True when no cell of the tile is chosen by any share, or all are whole: found without looking at most
/// of them.
bool chooses_none(const Mask& mask, int tile);
bool chooses_all(const Mask& mask, int tile);

/// Bytes of the tiles that are chosen in part; the others share one.
std::size_t bytes_in_part(const Mask& mask);

/// Builds a mask tile by tile: tiles that are chosen whole or not at all share their storage.
class MaskBuilder {
  public:
    explicit MaskBuilder(Shape shape) : mask_(shape) {}
    void set_tile(int tile, const std::uint8_t* chosen);
    Mask take() { return std::move(mask_); }

  private:
    Mask mask_;
    TileBlock<std::uint8_t> all_ = TileBlock<std::uint8_t>::filled(kWhole);
};

}  // namespace pastoso::grid
