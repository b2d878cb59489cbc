// Which cells of a picture a cell of its moved, turned and scaled copy is made of.
#pragma once

#include "grid/mask.hpp"

#include <vector>

namespace pastoso::layers {

/// x -> a x + b y + c, y -> d x + e y + f.
struct Affine {
    double a = 1.0, b = 0.0, c = 0.0;
    double d = 0.0, e = 1.0, f = 0.0;

    grid::Point operator()(double x, double y) const { return {a * x + b * y + c, d * x + e * y + f}; }
};

/// The other way round; a e != b d.
Affine inverse(const Affine& map);

/// A share of a cell.
struct CellShare {
    int x, y;
    double share;
};

/// The cells that a parallelogram covers, each with the share of the parallelogram's area that lies in
/// it: a mean of the picture over the parallelogram. It is what `to_source` makes of the cell (x, y),
/// with each side drawn out about its middle to at least one cell, so that an enlargement is an
/// interpolation between cells. The shares sum to 1, cells beyond the picture included; those of less
/// than 1e-12 are left out. Reused from cell to cell.
class Footprint {
  public:
    explicit Footprint(const Affine& to_source);
    const std::vector<CellShare>& of(int x, int y);

  private:
    void add_row(const std::vector<grid::Point>& corners, int row);

    Affine to_source_;
    grid::Point half_side_[2];  ///< of the parallelogram
    double area_;
    std::vector<CellShare> shares_;
    std::vector<grid::Point> corners_, clipped_, row_, cell_;
};

}  // namespace pastoso::layers
