// One level of the multigrid in checkerboard order. Cell (i, j, k) has the colour (i + j + k) & 1 and
// stands at m = i >> 1 in its colour's row: all six neighbours are of the other colour, those to the
// west and east at m + p - 1 and m + p with p = (j + k + colour) & 1, the others at the same m. So half
// a sweep reads one colour and writes the other, in whole registers and without a race between threads.
#pragma once

#include "core/thread_pool.hpp"
#include "liquid/flow/aligned_floats.hpp"
#include "liquid/flow/row_ranges.hpp"
#include "liquid/pressure/cell_matrix.hpp"
#include "liquid/pressure/components.hpp"
#include "liquid/pressure/multigrid_view.hpp"

#include <array>
#include <vector>

namespace pastoso::liquid {

/// Rows of both colours of a level.
class ColourField {
  public:
    ColourField() = default;
    explicit ColourField(const LevelExtent& extent)
        : extent_(extent),
          colours_{AlignedFloats(extent.sample_count(), 0.0F),
                   AlignedFloats(extent.sample_count(), 0.0F)} {}

    /// Where m = 0 of row (0, 0) stands.
    ColourPointers data() {
        return {
            {colours_[0].data() + extent_.index(0, 0, 0), colours_[1].data() + extent_.index(0, 0, 0)}};
    }
    float& at(int i, int j, int k) {
        return colours_[static_cast<std::size_t>((i + j + k) & 1)]
                       [static_cast<std::size_t>(extent_.index(i >> 1, j, k))];
    }
    float at(int i, int j, int k) const { return const_cast<ColourField&>(*this).at(i, j, k); }
    void fill(float value) {
        for (AlignedFloats& colour : colours_)
            colour.assign(colour.size(), value);
    }

  private:
    LevelExtent extent_;
    std::array<AlignedFloats, 2> colours_;
};

struct MultigridLevel {
    explicit MultigridLevel(const LevelExtent& extent);

    LevelExtent extent;
    ColourField west, south, below;  ///< coefficients of the faces before each cell
    ColourField diagonal, inverse;   ///< the cell's own factor, and 1 over it, or 0 where it is 0
    ColourField value, source;
    std::vector<GroupRange> rows;  ///< of each row (j, k) what m hold cells that take part
    PlainEquation plain;
    long cell_count = 0;      ///< that take part
    ClosedComponents closed;  ///< of the finest and the coarsest level

    LevelView view();
};

/// All levels of a box, the finest first, whose memory serves one matrix after the other. A coarse cell
/// is made of two along each axis that has more than one; its faces' coefficients are what the same
/// equation has on the wider grid: the sum over the fine faces, halved where the distance across them
/// doubles. (That is half of the Galerkin product with constant transfer, which would underestimate the
/// correction by two.)
class MultigridLevels {
  public:
    explicit MultigridLevels(const grid::BoxShape& shape);

    /// The cells of the matrix that take part must lie within `rows`.
    void set_matrix(const CellMatrix& matrix, const RowRanges& rows, core::ThreadPool& pool);

    std::vector<MultigridLevel>& levels() { return levels_; }
    const std::vector<MultigridLevel>& levels() const { return levels_; }

  private:
    std::vector<MultigridLevel> levels_;
    std::vector<CellMatrix> coarse_;  ///< those of all levels but the finest
    std::vector<RowRanges> rows_;     ///< what of each coarse matrix may not be 0
};

}  // namespace pastoso::liquid
