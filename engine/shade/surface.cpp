#include "shade/surface.hpp"

#include "grid/bspline.hpp"
#include "shade/cell_span.hpp"

#include <algorithm>
#include <vector>

namespace pastoso::shade {

HeightRange united(const HeightRange& a, const HeightRange& b) {
    return {std::min(a.lowest_mm, b.lowest_mm), std::max(a.highest_mm, b.highest_mm)};
}

namespace {

using grid::kPrefilterReach;
using grid::kPrefilterTaps;
using grid::Rect;

/// Cell means with a margin of kPrefilterReach cells all around, and room for the columns' pass.
struct Means {
    explicit Means(const Rect& cells)
        : margin(grown(cells, kPrefilterReach)),
          values(static_cast<std::size_t>(margin.width()) * margin.height()),
          columns(static_cast<std::size_t>(margin.width()) * cells.height()) {}

    Rect margin;
    std::vector<float> values;
    std::vector<float> columns;
};

void filter_columns(Means& means, int height) {
    const int width = means.margin.width();
    for (int y = 0; y < height; ++y) {
        const float* source = means.values.data() + static_cast<std::ptrdiff_t>(y) * width;
        float* target = means.columns.data() + static_cast<std::ptrdiff_t>(y) * width;
        for (int x = 0; x < width; ++x) {
            target[x] = kPrefilterTaps[0] * (source[x] + source[x + 4 * width]) +
                        kPrefilterTaps[1] * (source[x + width] + source[x + 3 * width]) +
                        kPrefilterTaps[2] * source[x + 2 * width];
        }
    }
}

/// Calls put(x, coefficient) for the cells of row y of the rectangle.
template <class Put>
void filter_row(const Means& means, int y, int width, const Put& put) {
    const float* source = means.columns.data() + static_cast<std::ptrdiff_t>(y) * means.margin.width();
    for (int x = 0; x < width; ++x) {
        put(x, kPrefilterTaps[0] * (source[x] + source[x + 4]) +
                   kPrefilterTaps[1] * (source[x + 1] + source[x + 3]) +
                   kPrefilterTaps[2] * source[x + 2]);
    }
}

void gather_support(const film::FilmState& film, const Rect& cells, float* out) {
    const auto fill = [&film](const Rect& part, float* target, int stride) {
        gather_cells(film.shape, part, target, stride, [&](int tile, int cell, int count, float* to) {
            film.support_mm.read(tile).copy(cell, count, to);
        });
    };
    fill_beyond_edges(film.shape, cells, out, cells.width(), fill);
}

void put_support(const film::FilmState& film, const Rect& cells, Means& means, float* out, int stride) {
    gather_support(film, means.margin, means.values.data());
    filter_columns(means, cells.height());
    for (int y = 0; y < cells.height(); ++y) {
        float* row = out + static_cast<std::ptrdiff_t>(y) * stride;
        filter_row(means, y, cells.width(), [row](int x, float coefficient) { row[x] = coefficient; });
    }
}

void add_paint(const film::FilmState& film, const Rect& cells, Means& means, float* out, int stride) {
    thickness_means(film, means.margin, means.values.data(), means.margin.width());
    filter_columns(means, cells.height());
    for (int y = 0; y < cells.height(); ++y) {
        float* row = out + static_cast<std::ptrdiff_t>(y) * stride;
        filter_row(means, y, cells.width(),
                   [row](int x, float coefficient) { row[x] += std::max(coefficient, 0.0F); });
    }
}

/// The least and the greatest of what fill(film, cells, out, stride) gives for a tile.
template <class Fill>
HeightRange range_of_tile(const film::FilmState& film, int tile, const Fill& fill) {
    float values[grid::kTileCells];
    const Rect cells = film.shape.tile_cells(tile);
    fill(film, cells, values, cells.width());
    const auto [low, high] = std::minmax_element(values, values + cells.width() * cells.height());
    return {*low, *high};
}

/// The same for all tiles.
template <class Fill>
HeightRange range_of(const film::FilmState& film, const Fill& fill) {
    HeightRange range{film.support_mm.at(0, 0), film.support_mm.at(0, 0)};
    for (int tile = 0; tile < film.shape.tile_count(); ++tile)
        range = united(range, range_of_tile(film, tile, fill));
    return range;
}

}  // namespace

void thickness_means(const film::FilmState& film, const Rect& cells, float* out, int stride) {
    const auto fill = [&film](const Rect& part, float* target, int target_stride) {
        gather_cells(film.shape, part, target, target_stride,
                     [&](int tile, int cell, int count, float* to) {
                         const std::int32_t* thickness = film.thickness.read(tile) + cell;
                         for (int i = 0; i < count; ++i)
                             to[i] = film::thickness_mm(thickness[i]);
                     });
    };
    fill_beyond_edges(film.shape, cells, out, stride, fill);
}

void surface_means(const film::FilmState& film, const Rect& cells, float* out, int stride) {
    const auto fill = [&film](const Rect& part, float* target, int target_stride) {
        gather_cells(film.shape, part, target, target_stride,
                     [&](int tile, int cell, int count, float* to) {
                         film.support_mm.read(tile).copy(cell, count, to);
                         const std::int32_t* thickness = film.thickness.read(tile) + cell;
                         for (int i = 0; i < count; ++i)
                             to[i] += film::thickness_mm(thickness[i]);
                     });
    };
    fill_beyond_edges(film.shape, cells, out, stride, fill);
}

void height_coefficients(const film::FilmState& film, const Rect& cells, float* out, int stride) {
    const auto fill = [&film](const Rect& part, float* target, int target_stride) {
        Means means(part);
        put_support(film, part, means, target, target_stride);
        add_paint(film, part, means, target, target_stride);
    };
    fill_beyond_edges(film.shape, cells, out, stride, fill);
}

void support_coefficients(const film::FilmState& film, const Rect& cells, float* out, int stride) {
    const auto fill = [&film](const Rect& part, float* target, int target_stride) {
        Means means(part);
        put_support(film, part, means, target, target_stride);
    };
    fill_beyond_edges(film.shape, cells, out, stride, fill);
}

void paint_coefficients(const film::FilmState& film, const Rect& cells, float* out, int stride) {
    const auto fill = [&film](const Rect& part, float* target, int target_stride) {
        for (int y = 0; y < part.height(); ++y)
            std::fill_n(target + static_cast<std::ptrdiff_t>(y) * target_stride, part.width(), 0.0F);
        Means means(part);
        add_paint(film, part, means, target, target_stride);
    };
    fill_beyond_edges(film.shape, cells, out, stride, fill);
}

HeightRange surface_range(const film::FilmState& film) {
    return range_of(film, surface_means);
}

void TileRanges::update(const film::FilmState& film, const std::vector<int>& tiles) {
    ranges_.resize(static_cast<std::size_t>(film.shape.tile_count()));
    for (const int tile : tiles)
        ranges_[tile] = range_of_tile(film, tile, surface_means);
}

HeightRange TileRanges::all() const {
    HeightRange range = ranges_.at(0);
    for (const HeightRange& tile : ranges_)
        range = united(range, tile);
    return range;
}

HeightRange surface_bounds(const film::FilmState& film) {
    return range_of(film, height_coefficients);
}

}  // namespace pastoso::shade
