// Cell means of a height function: shared by the kinds of support.
#pragma once

#include "film/support.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <span>
#include <vector>

namespace pastoso::film {

/// Samples a cell needs along each side, when the surface's finest features are `feature_mm` wide.
inline int samples_per_cell(double cell_mm, double feature_mm) {
    return std::clamp(static_cast<int>(std::ceil(cell_mm / feature_mm)), 1, 32);
}

/// A field of cell means of relief_mm * height, rounded down to multiples of kSupportQuantum_mm.
/// fill_row(y, heights) writes the heights, 0 to 1, along the line at y cells from the top; heights[k]
/// is at x = (k + 0.5) / samples cells. Rows are asked for from top to bottom.
template <class FillRow>
grid::TiledField<float> sample_cell_means(grid::Shape shape, int samples, double relief_mm,
                                          const FillRow& fill_row) {
    grid::TiledField<float> field(shape);
    std::vector<float> heights(static_cast<std::size_t>(shape.width) * samples);
    std::vector<double> sums(static_cast<std::size_t>(shape.width));
    const double quanta_per_sum = relief_mm / (kSupportQuantum_mm * samples * samples);
    for (int y = 0; y < shape.height; ++y) {
        std::fill(sums.begin(), sums.end(), 0.0);
        for (int sample = 0; sample < samples; ++sample) {
            fill_row(y + (sample + 0.5) / samples, std::span<float>(heights));
            for (std::size_t k = 0; k < heights.size(); ++k)
                sums[k / samples] += heights[k];
        }
        for (int x = 0; x < shape.width; ++x) {
            const double height_mm = std::floor(sums[x] * quanta_per_sum) * kSupportQuantum_mm;
            field.write(shape.tile_at(x, y))[grid::Shape::cell_in_tile(x, y)] =
                static_cast<float>(height_mm);
        }
    }
    return field;
}

}  // namespace pastoso::film
