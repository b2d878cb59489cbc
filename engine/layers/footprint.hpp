// Which cells of a picture a cell of its copy is made of that is moved, turned, scaled or in
// perspective.
#pragma once

#include "grid/mask.hpp"
#include "layers/projective.hpp"

#include <vector>

namespace pastoso::layers {

/// A share of a cell.
struct CellShare {
    int x, y;
    double share;
};

/// Cells far beyond any picture.
inline constexpr grid::Rect kAnywhere{-(1 << 30), -(1 << 30), 1 << 30, 1 << 30};

/// The cells that a parallelogram covers, each with the share of the parallelogram's area that lies in
/// it: a mean of the picture over the parallelogram. It is what `to_source` makes of the cell (x, y), of
/// one in perspective by the steps about its middle, with each side drawn out about its middle to at
/// least one cell, so that an enlargement is an interpolation between cells. The shares sum to 1, cells
/// beyond the picture included; those of less than 1e-12, and those that do not lie `within`, are left
/// out. Reused from cell to cell.
///
/// In perspective, a cell of less than half the depth that the farthest corner has (onto_corners()) has
/// no shares: towards the horizon pictures become infinitely small.
class Footprint {
  public:
    explicit Footprint(const Projective& to_source, const grid::Rect& within = kAnywhere);
    const std::vector<CellShare>& of(int x, int y);

  private:
    void add_row(const std::vector<grid::Point>& corners, double area, int row);

    Projective to_source_;
    grid::Rect within_;
    std::vector<CellShare> shares_;
    std::vector<grid::Point> corners_, clipped_, row_, cell_;
};

/// Whether the cell (x, y) comes from anywhere.
bool comes_from_somewhere(const Projective& to_source, int x, int y);

}  // namespace pastoso::layers
