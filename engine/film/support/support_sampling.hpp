// Cell means of a height function: shared by the kinds of support.
#pragma once

#include "core/thread_pool.hpp"
#include "film/support/support.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace pastoso::film {

/// Samples a cell needs along each side, when the surface's finest features are `feature_mm` wide.
inline int samples_per_cell(double cell_mm, double feature_mm) {
    return std::clamp(static_cast<int>(std::ceil(cell_mm / feature_mm)), 1, 32);
}

/// The cells that are sampled; the surface's own rows count from another one.
struct SampledCells {
    grid::Shape shape;
    int first_row = 0;  ///< of the surface, where the cells' row 0 lies
};

/// Of every cell of a row, y being the surface's: the sum of `samples` x `samples` heights.
/// fill_row(y, heights) writes the heights along the line at y cells from the surface's origin;
/// heights[k] is at x = (k + 0.5) / samples cells.
template <class FillRow>
void sum_samples(int y, int samples, std::vector<float>& heights, std::vector<double>& sums,
                 FillRow& fill_row) {
    if (samples == 1) {
        fill_row(y + 0.5, std::span<float>(heights));
        std::copy(heights.begin(), heights.end(), sums.begin());
        return;
    }
    std::fill(sums.begin(), sums.end(), 0.0);
    for (int sample = 0; sample < samples; ++sample) {
        fill_row(y + (sample + 0.5) / samples, std::span<float>(heights));
        const float* height = heights.data();
        for (double& sum : sums)
            for (int k = 0; k < samples; ++k)
                sum += *height++;
    }
}

/// Cell means of relief_mm * height as floats, rounded down to multiples of kSupportQuantum_mm. Rows are
/// asked for from top to bottom.
template <class FillRow>
SupportHeights sampled_heights(const SampledCells& cells, int samples, double relief_mm,
                               FillRow fill_row) {
    const grid::Shape& shape = cells.shape;
    SupportHeights field(shape);
    std::vector<float> heights(static_cast<std::size_t>(shape.width) * samples);
    std::vector<double> sums(static_cast<std::size_t>(shape.width));
    const double quanta_per_sum = relief_mm / (kSupportQuantum_mm * samples * samples);
    for (int y = 0; y < shape.height; ++y) {
        sum_samples(cells.first_row + y, samples, heights, sums, fill_row);
        for (int x = 0; x < shape.width; ++x) {
            const double height_mm = std::floor(sums[x] * quanta_per_sum) * kSupportQuantum_mm;
            field.write(shape.tile_at(x, y))[grid::Shape::cell_in_tile(x, y)] =
                static_cast<float>(height_mm);
        }
    }
    return field;
}

/// The tiles of one row of tiles, as levels.
template <class FillRow>
void sample_tile_row(int row, int first_row, int samples, double level_mm, double relief_mm,
                     FillRow& fill_row, SupportHeights& field) {
    using grid::kTileSize;
    const grid::Shape& shape = field.shape();
    std::vector<float> heights(static_cast<std::size_t>(shape.width) * samples);
    std::vector<double> sums(static_cast<std::size_t>(shape.width));
    std::vector<grid::TileBlock<std::uint16_t>> blocks;
    for (int column = 0; column < shape.tiles_x(); ++column)
        blocks.push_back(grid::TileBlock<std::uint16_t>::filled(0));
    const double levels_per_sum = relief_mm / (level_mm * samples * samples);
    const int end = std::min(shape.height, (row + 1) * kTileSize);
    for (int y = row * kTileSize; y < end; ++y) {
        sum_samples(first_row + y, samples, heights, sums, fill_row);
        for (int column = 0; column < shape.tiles_x(); ++column) {
            const int x0 = column * kTileSize, count = std::min(kTileSize, shape.width - x0);
            std::uint16_t* levels = blocks[column].write() + grid::Shape::cell_in_tile(x0, y);
            for (int k = 0; k < count; ++k)
                levels[k] = static_cast<std::uint16_t>(sums[x0 + k] * levels_per_sum);
        }
    }
    for (int column = 0; column < shape.tiles_x(); ++column)
        field.replace(row * shape.tiles_x() + column,
                      HeightBlock(std::move(blocks[column]), static_cast<float>(level_mm)));
}

/// Cell means of relief_mm * height, heights being 0 to 1, in levels of finest_level_mm(relief_mm),
/// rounded down. make_fill_row() makes what fills rows; it is asked for rows from top to bottom, and for
/// each band of rows another one is made.
template <class MakeFillRow>
SupportHeights sampled_levels(const SampledCells& cells, int samples, double relief_mm,
                              core::ThreadPool& pool, const MakeFillRow& make_fill_row) {
    const grid::Shape& shape = cells.shape;
    constexpr int kBand = 4;  // rows of tiles
    SupportHeights field(shape);
    const double level_mm = finest_level_mm(relief_mm);
    const int bands = (shape.tiles_y() + kBand - 1) / kBand;
    pool.run(static_cast<std::size_t>(bands), [&](std::size_t index, int) {
        const int band = static_cast<int>(index);
        auto fill_row = make_fill_row();
        for (int row = band * kBand; row < std::min(shape.tiles_y(), (band + 1) * kBand); ++row)
            sample_tile_row(row, cells.first_row, samples, level_mm, relief_mm, fill_row, field);
    });
    return field;
}

/// The same, heights being 0 to 1, in either form.
template <class MakeFillRow>
SupportHeights sampled_in(SupportForm form, const SampledCells& cells, int samples, double relief_mm,
                          core::ThreadPool& pool, const MakeFillRow& make_fill_row) {
    if (form == SupportForm::Fine) return sampled_heights(cells, samples, relief_mm, make_fill_row());
    return sampled_levels(cells, samples, relief_mm, pool, make_fill_row);
}

}  // namespace pastoso::film
