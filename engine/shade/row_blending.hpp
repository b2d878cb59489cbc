// Layers of cells to the points of a row of samples. Included by files that are compiled once per
// instruction set.
#pragma once

#include "shade/kernels.hpp"

namespace pastoso::shade::PASTOSO_ISA {

/// Samples are taken in groups, so that what lies between the two loops over them stays in the cache.
constexpr int kGroup = 64;

/// Layers at one height y, for a stretch of cells.
struct ReliefLine {
    alignas(64) float height[kMaxRowCells], slope[kMaxRowCells], bend[kMaxRowCells];
};
struct LightLine {
    alignas(64) float shadow[kMaxRowCells], sky[kMaxRowCells];
};
struct ColourLine {
    alignas(64) CellColour colour[kMaxRowCells];
};

struct PointGroup {
    alignas(64) float height_mm[kGroup], slope_x[kGroup], slope_y[kGroup], shadow_mm[kGroup],
        sky[kGroup];
    alignas(64) float bend_xx[kGroup], bend_xy[kGroup], bend_yy[kGroup];
    alignas(64) float red[kGroup], green[kGroup], blue[kGroup], wetness[kGroup];
};

[[gnu::always_inline]] inline float blend(const std::array<const float*, 4>& rows,
                                          const std::array<float, 4>& weights, int x) {
    return weights[0] * rows[0][x] + weights[1] * rows[1][x] + weights[2] * rows[2][x] +
           weights[3] * rows[3][x];
}

[[gnu::always_inline]] inline float blend(const float* cells,
                                          const std::array<std::vector<float>, 4>& weights, int i) {
    return weights[0][i] * cells[0] + weights[1][i] * cells[1] + weights[2][i] * cells[2] +
           weights[3][i] * cells[3];
}

// Between the rows, for the cells [from, to) of the layers; a line begins with cell `begin`.

inline void blend_relief(const std::array<const float*, 4>& rows, const AxisWeights& weights, int begin,
                         int from, int to, ReliefLine& __restrict line) {
    for (int x = from; x < to; ++x) {
        line.height[x - begin] = blend(rows, weights.spline, x);
        line.slope[x - begin] = blend(rows, weights.slope, x);
        line.bend[x - begin] = blend(rows, weights.bend, x);
    }
}

inline void blend_light(const LayerRows& rows, const AxisWeights& weights, int begin, int from, int to,
                        LightLine& __restrict line) {
    for (int x = from; x < to; ++x) {
        line.shadow[x - begin] = blend(rows.shadow, weights.spline, x);
        line.sky[x - begin] = blend(rows.sky, weights.spline, x);
    }
}

inline void blend_colours(const std::array<const CellColour*, 4>& rows, const AxisWeights& weights,
                          int begin, int from, int to, ColourLine& __restrict line) {
    for (int x = from; x < to; ++x) {
        CellColour sum;
        for (int k = 0; k < 4; ++k) {
            const CellColour& cell = rows[k][x];
            sum.red += weights.colour[k] * cell.red;
            sum.green += weights.colour[k] * cell.green;
            sum.blue += weights.colour[k] * cell.blue;
            sum.wetness += weights.colour[k] * cell.wetness;
        }
        line.colour[x - begin] = sum;
    }
}

// Along a line that begins with cell `begin`, for the samples [first, first + count).

inline void place_height(const ReliefLine& line, int begin, const SampleColumns& columns, int first,
                         int count, PointGroup& __restrict points) {
    for (int i = 0; i < count; ++i)
        points.height_mm[i] =
            blend(line.height + columns.first_cell[first + i] - begin, columns.spline, first + i);
}

inline void place_relief(const ReliefLine& line, int begin, const SampleColumns& columns, int first,
                         int count, PointGroup& __restrict points) {
    for (int i = 0; i < count; ++i) {
        const int cell = columns.first_cell[first + i] - begin;
        points.height_mm[i] = blend(line.height + cell, columns.spline, first + i);
        points.slope_x[i] = blend(line.height + cell, columns.slope, first + i);
        points.slope_y[i] = blend(line.slope + cell, columns.spline, first + i);
        points.bend_xx[i] = blend(line.height + cell, columns.bend, first + i);
        points.bend_xy[i] = blend(line.slope + cell, columns.slope, first + i);
        points.bend_yy[i] = blend(line.bend + cell, columns.spline, first + i);
    }
}

inline void place_light(const LightLine& line, int begin, const SampleColumns& columns, int first,
                        int count, PointGroup& __restrict points) {
    for (int i = 0; i < count; ++i) {
        const int cell = columns.first_cell[first + i] - begin;
        points.shadow_mm[i] = blend(line.shadow + cell, columns.spline, first + i);
        points.sky[i] = blend(line.sky + cell, columns.spline, first + i);
    }
}

inline void place_colours(const ColourLine& line, int begin, const SampleColumns& columns, int first,
                          int count, PointGroup& __restrict points) {
    for (int i = 0; i < count; ++i) {
        const int cell = columns.first_cell[first + i] - begin;
        CellColour sum;
        for (int k = 0; k < 4; ++k) {
            const CellColour& colour = line.colour[cell + k];
            sum.red += columns.colour[k][first + i] * colour.red;
            sum.green += columns.colour[k][first + i] * colour.green;
            sum.blue += columns.colour[k][first + i] * colour.blue;
            sum.wetness += columns.colour[k][first + i] * colour.wetness;
        }
        points.red[i] = sum.red;
        points.green[i] = sum.green;
        points.blue[i] = sum.blue;
        points.wetness[i] = sum.wetness;
    }
}

/// The layers of a row of samples, between the rows.
struct RowLines {
    RowLines(const LayerRows& rows, const AxisWeights& weights, const SampleColumns& samples)
        : columns(samples), begin(samples.first_cell[0]) {
        const int end = samples.first_cell[samples.count - 1] + 4;
        blend_relief(rows.height, weights, begin, begin, end, relief);
        blend_light(rows, weights, begin, begin, end, light);
        blend_colours(rows.colour, weights, begin, begin, end, colours);
    }

    /// The samples [first, first + count).
    void place(int first, int count, PointGroup& points) const {
        place_relief(relief, begin, columns, first, count, points);
        place_light(light, begin, columns, first, count, points);
        place_colours(colours, begin, columns, first, count, points);
    }

    const SampleColumns& columns;
    int begin;
    ReliefLine relief;
    LightLine light;
    ColourLine colours;
};

inline void shade_points(const PointGroup& points, int count, float cells_per_mm,
                         const ShadingConstants& light, float* __restrict rgb) {
    for (int i = 0; i < count; ++i) {
        const ShadedPoint shaded = shade(
            {points.height_mm[i], points.slope_x[i] * cells_per_mm, points.slope_y[i] * cells_per_mm,
             points.bend_xx[i] * cells_per_mm, points.bend_xy[i] * cells_per_mm,
             points.bend_yy[i] * cells_per_mm, points.shadow_mm[i], points.sky[i], points.wetness[i],
             points.red[i], points.green[i], points.blue[i]},
            light);
        rgb[3 * i] = shaded.red;
        rgb[3 * i + 1] = shaded.green;
        rgb[3 * i + 2] = shaded.blue;
    }
}

inline void store_points(const PointGroup& points, int count, float cells_per_mm,
                         SurfaceSample* __restrict out) {
    for (int i = 0; i < count; ++i) {
        out[i] = {points.red[i],
                  points.green[i],
                  points.blue[i],
                  clamp_to_unit(points.wetness[i]),
                  points.height_mm[i],
                  points.slope_x[i] * cells_per_mm,
                  points.slope_y[i] * cells_per_mm};
    }
}

}  // namespace pastoso::shade::PASTOSO_ISA
