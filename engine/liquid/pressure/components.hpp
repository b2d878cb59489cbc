// The connected parts of the cells of a matrix, and which of them are closed: there the solution is
// known up to a constant only.
#pragma once

#include "liquid/flow/row_ranges.hpp"
#include "liquid/pressure/cell_matrix.hpp"

#include <vector>

namespace pastoso::liquid {

struct ClosedComponents {
    int count = 0;
    /// Of cell (i, j, k) at (k ny + j) nx + i: 0 where the cell takes no part or its component is open,
    /// else the component's number from 1.
    std::vector<int> of_cell;
    std::vector<long> sizes;  ///< how many cells each has; at 0 of all other cells
};

/// The cells of the matrix that take part must lie within `rows`. `components` is overwritten; its
/// memory is used again.
void compute_closed_components(const CellMatrix& matrix, const RowRanges& rows,
                               ClosedComponents& components);

}  // namespace pastoso::liquid
