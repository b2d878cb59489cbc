// The rows of a box around those that matter.
#pragma once

#include "liquid/flow/row_ranges.hpp"

namespace pastoso::tank {

/// The ranges widened by `reach` samples in every direction, within the given number of samples along
/// each axis: at most one more than the box has cells.
liquid::RowRanges widened(const liquid::RowRanges& rows, const grid::BoxShape& shape, int reach,
                          const std::array<int, 3>& counts);

/// Within the cells of the box.
inline liquid::RowRanges widened_cells(const liquid::RowRanges& rows, const grid::BoxShape& shape,
                                       int reach) {
    return widened(rows, shape, reach, {shape.nx, shape.ny, shape.nz});
}
/// Within the samples that there are of any location: one more than cells along each axis.
inline liquid::RowRanges widened_samples(const liquid::RowRanges& rows, const grid::BoxShape& shape,
                                         int reach) {
    return widened(rows, shape, reach, {shape.nx + 1, shape.ny + 1, shape.nz + 1});
}

/// What rows of either hold.
liquid::RowRanges united(const liquid::RowRanges& a, const liquid::RowRanges& b,
                         const grid::BoxShape& shape);

}  // namespace pastoso::tank
