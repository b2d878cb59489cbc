// For each row of a box the samples that matter: loops run over these alone.
#pragma once

#include "liquid/flow/velocity.hpp"

#include <vector>

namespace pastoso::liquid {

struct RowRange {
    int begin = 0, end = 0;
    bool empty() const { return begin >= end; }
    friend bool operator==(const RowRange&, const RowRange&) = default;
};

/// One range for each row (j, k), 0 <= j <= ny, 0 <= k <= nz.
class RowRanges {
  public:
    RowRanges() = default;
    explicit RowRanges(const grid::BoxShape& shape)
        : rows_y_(shape.ny + 1),
          ranges_(static_cast<std::size_t>(rows_y_) * static_cast<std::size_t>(shape.nz + 1)) {}

    /// All samples of a location.
    static RowRanges whole(const grid::BoxShape& shape, Location location) {
        RowRanges ranges(shape);
        const auto [nx, ny, nz] = sample_counts(shape, location);
        for (int k = 0; k < nz; ++k)
            for (int j = 0; j < ny; ++j)
                ranges.at(j, k) = {0, nx};
        return ranges;
    }

    RowRange& at(int j, int k) { return ranges_[static_cast<std::size_t>(k * rows_y_ + j)]; }
    const RowRange& at(int j, int k) const { return ranges_[static_cast<std::size_t>(k * rows_y_ + j)]; }

    /// Widens a row's range so that it holds sample i.
    void include(int i, int j, int k) {
        RowRange& range = at(j, k);
        range = range.empty()
                    ? RowRange{i, i + 1}
                    : RowRange{i < range.begin ? i : range.begin, i < range.end ? range.end : i + 1};
    }

  private:
    int rows_y_ = 0;
    std::vector<RowRange> ranges_;
};

}  // namespace pastoso::liquid
