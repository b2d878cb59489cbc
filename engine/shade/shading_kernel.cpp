#include "shade/row_blending.hpp"

#include <algorithm>

namespace pastoso::shade::PASTOSO_ISA {
namespace {

/// Calls use(points, first, count) for the samples of a row, group by group.
template <class Use>
void for_each_group(const LayerRows& rows, const AxisWeights& row_weights, const SampleColumns& columns,
                    const Use& use) {
    const RowLines lines(rows, row_weights, columns);
    PointGroup points;
    for (int first = 0; first < columns.count; first += kGroup) {
        const int count = std::min(kGroup, columns.count - first);
        lines.place(first, count, points);
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
