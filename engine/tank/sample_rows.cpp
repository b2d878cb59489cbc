#include "tank/sample_rows.hpp"

#include <algorithm>

namespace pastoso::tank {
namespace {

using liquid::RowRange;
using liquid::RowRanges;

RowRange hull(const RowRange& a, const RowRange& b) {
    if (a.empty()) return b;
    if (b.empty()) return a;
    return {std::min(a.begin, b.begin), std::max(a.end, b.end)};
}

}  // namespace

RowRanges widened(const RowRanges& rows, const grid::BoxShape& shape, int reach,
                  const std::array<int, 3>& counts) {
    const auto [nx, ny, nz] = counts;
    RowRanges along_y(shape), all(shape);
    for (int k = 0; k <= shape.nz; ++k)
        for (int j = 0; j <= shape.ny; ++j) {
            const RowRange row = rows.at(j, k);
            if (row.empty()) continue;
            const RowRange wide = {std::max(row.begin - reach, 0), std::min(row.end + reach, nx)};
            for (int near = std::max(j - reach, 0); near <= std::min(j + reach, ny - 1); ++near)
                along_y.at(near, k) = hull(along_y.at(near, k), wide);
        }
    for (int k = 0; k <= shape.nz; ++k)
        for (int j = 0; j < ny; ++j) {
            const RowRange row = along_y.at(j, k);
            if (row.empty()) continue;
            for (int near = std::max(k - reach, 0); near <= std::min(k + reach, nz - 1); ++near)
                all.at(j, near) = hull(all.at(j, near), row);
        }
    return all;
}

RowRanges united(const RowRanges& a, const RowRanges& b, const grid::BoxShape& shape) {
    RowRanges both(shape);
    for (int k = 0; k <= shape.nz; ++k)
        for (int j = 0; j <= shape.ny; ++j)
            both.at(j, k) = hull(a.at(j, k), b.at(j, k));
    return both;
}

}  // namespace pastoso::tank
