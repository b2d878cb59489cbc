#include "shade/kernels.hpp"

#include <algorithm>

namespace pastoso::shade::PASTOSO_ISA {
namespace {

/// Samples are taken in groups, so that what lies between the two loops over them stays in the cache.
constexpr int kGroup = 64;

/// The layers at one height y, for a stretch of cells.
struct CellLine {
    alignas(64) float height[kMaxRowCells], height_slope[kMaxRowCells];
    alignas(64) float height_bend[kMaxRowCells];
    alignas(64) float shadow[kMaxRowCells], sky[kMaxRowCells];
    alignas(64) CellColour colour[kMaxRowCells];
};

struct PointGroup {
    alignas(64) float height_mm[kGroup], slope_x[kGroup], slope_y[kGroup], shadow_mm[kGroup],
        sky[kGroup];
    alignas(64) float bend_xx[kGroup], bend_xy[kGroup], bend_yy[kGroup];
    alignas(64) float red[kGroup], green[kGroup], blue[kGroup], wetness[kGroup];
};

float blend(const std::array<const float*, 4>& rows, const std::array<float, 4>& weights, int x) {
    return weights[0] * rows[0][x] + weights[1] * rows[1][x] + weights[2] * rows[2][x] +
           weights[3] * rows[3][x];
}

/// Interpolates between the rows, for the cells [begin, end) of the layers.
void blend_rows(const LayerRows& rows, const AxisWeights& weights, int begin, int end, CellLine& line) {
    for (int x = begin; x < end; ++x) {
        line.height[x - begin] = blend(rows.height, weights.spline, x);
        line.height_slope[x - begin] = blend(rows.height, weights.slope, x);
        line.height_bend[x - begin] = blend(rows.height, weights.bend, x);
        line.shadow[x - begin] = blend(rows.shadow, weights.spline, x);
        line.sky[x - begin] = blend(rows.sky, weights.spline, x);
    }
    for (int x = begin; x < end; ++x) {
        CellColour sum;
        for (int k = 0; k < 4; ++k) {
            const CellColour& cell = rows.colour[k][x];
            sum.red += weights.colour[k] * cell.red;
            sum.green += weights.colour[k] * cell.green;
            sum.blue += weights.colour[k] * cell.blue;
            sum.wetness += weights.colour[k] * cell.wetness;
        }
        line.colour[x - begin] = sum;
    }
}

float blend(const float* cells, const std::array<std::vector<float>, 4>& weights, int i) {
    return weights[0][i] * cells[0] + weights[1][i] * cells[1] + weights[2][i] * cells[2] +
           weights[3][i] * cells[3];
}

/// Interpolates along the line, for the samples [first, first + count).
void blend_cells(const CellLine& line, int begin, const SampleColumns& columns, int first, int count,
                 PointGroup& points) {
    for (int i = 0; i < count; ++i) {
        const int cell = columns.first_cell[first + i] - begin;
        points.height_mm[i] = blend(line.height + cell, columns.spline, first + i);
        points.slope_x[i] = blend(line.height + cell, columns.slope, first + i);
        points.slope_y[i] = blend(line.height_slope + cell, columns.spline, first + i);
        points.bend_xx[i] = blend(line.height + cell, columns.bend, first + i);
        points.bend_xy[i] = blend(line.height_slope + cell, columns.slope, first + i);
        points.bend_yy[i] = blend(line.height_bend + cell, columns.spline, first + i);
        points.shadow_mm[i] = blend(line.shadow + cell, columns.spline, first + i);
        points.sky[i] = blend(line.sky + cell, columns.spline, first + i);
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

void shade_points(const PointGroup& points, int count, float cells_per_mm, const ShadingConstants& light,
                  float* rgb) {
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

void store_points(const PointGroup& points, int count, float cells_per_mm, SurfaceSample* out) {
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

/// Calls use(points, first, count) for the samples of a row, group by group.
template <class Use>
void for_each_group(const LayerRows& rows, const AxisWeights& row_weights, const SampleColumns& columns,
                    const Use& use) {
    const int begin = columns.first_cell[0];
    const int end = columns.first_cell[columns.count - 1] + 4;
    CellLine line;
    PointGroup points;
    blend_rows(rows, row_weights, begin, end, line);
    for (int first = 0; first < columns.count; first += kGroup) {
        const int count = std::min(kGroup, columns.count - first);
        blend_cells(line, begin, columns, first, count, points);
        use(points, first, count);
    }
}

}  // namespace

void shade_row(const LayerRows& rows, const AxisWeights& row_weights, const SampleColumns& columns,
               float cell_mm, const ShadingConstants& light, float* rgb) {
    for_each_group(rows, row_weights, columns, [&](const PointGroup& points, int first, int count) {
        shade_points(points, count, 1.0F / cell_mm, light, rgb + 3 * first);
    });
}

void sample_row(const LayerRows& rows, const AxisWeights& row_weights, const SampleColumns& columns,
                float cell_mm, SurfaceSample* out) {
    for_each_group(rows, row_weights, columns, [&](const PointGroup& points, int first, int count) {
        store_points(points, count, 1.0F / cell_mm, out + first);
    });
}

}  // namespace pastoso::shade::PASTOSO_ISA
