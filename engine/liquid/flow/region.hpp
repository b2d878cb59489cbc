// Where a fluid is in a box of cells: how much of each face is open to it, and which cells and faces
// that leaves.
#pragma once

#include "liquid/flow/row_ranges.hpp"
#include "liquid/flow/velocity.hpp"

namespace pastoso::liquid {

class Region {
  public:
    /// A share of 0 to 1 for each face; those of the box itself must be 0.
    explicit Region(VelocityField open);

    const grid::BoxShape& shape() const { return open_.shape(); }
    /// The open share of each face, 0 to 1.
    const VelocityField& open() const { return open_; }
    /// 1 in cells that have an open face, 0 in all others.
    const grid::BoxField& open_cells() const { return open_cells_; }
    /// The rows' open cells or faces, with what shut ones lie between them.
    const RowRanges& rows(Location location) const { return rows_[static_cast<std::size_t>(location)]; }
    long open_cell_count() const { return open_cell_count_; }

  private:
    void compute_open_cells();
    void compute_face_rows();

    VelocityField open_;
    grid::BoxField open_cells_;
    std::array<RowRanges, 4> rows_;
    long open_cell_count_ = 0;
};

}  // namespace pastoso::liquid
