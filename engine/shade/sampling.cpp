#include "shade/sampling.hpp"

#include "grid/bspline.hpp"

#include <algorithm>
#include <cmath>

namespace pastoso::shade {
namespace {

/// The cubic of Mitchell and Netravali for 1 <= x < 2 and for 0 <= x < 1.
float outer_cubic(float x) {
    return ((-7.0F * x + 36.0F) * x - 60.0F) * x / 18.0F + 16.0F / 9.0F;
}
float inner_cubic(float x) {
    return (7.0F * x - 12.0F) * x * x / 6.0F + 8.0F / 9.0F;
}

}  // namespace

std::array<float, 4> colour_weights(float t, float sharpness) {
    const std::array<float, 4> sharp = {outer_cubic(1.0F + t), inner_cubic(t), inner_cubic(1.0F - t),
                                        outer_cubic(2.0F - t)};
    std::array<float, 4> weights = grid::bspline_weights(t).value;
    for (int k = 0; k < 4; ++k)
        weights[k] += sharpness * (sharp[k] - weights[k]);
    return weights;
}

float colour_sharpness(double scale) {
    return static_cast<float>(std::clamp((4.0 - scale) / 3.0, 0.0, 1.0));
}

SampleAxis sample_axis(const SampleGrid& samples, int first, int count, int layer_origin) {
    SampleAxis axis;
    axis.first_cell.resize(count);
    axis.weights.resize(count);
    for (int i = 0; i < count; ++i) {
        const double position = samples.origin + (first + i + 0.5) * samples.spacing - 0.5;
        const double cell = std::floor(position);
        const auto t = static_cast<float>(position - cell);
        const grid::BsplineWeights spline = grid::bspline_weights(t);
        axis.first_cell[i] = static_cast<int>(cell) - 1 - layer_origin;
        axis.weights[i] = {spline.value, spline.slope, spline.bend,
                           colour_weights(t, samples.sharpness)};
    }
    return axis;
}

SampleColumns::SampleColumns(const SampleAxis& axis)
    : count(static_cast<int>(axis.first_cell.size())), first_cell(axis.first_cell) {
    for (int k = 0; k < 4; ++k) {
        for (const AxisWeights& weights : axis.weights) {
            spline[k].push_back(weights.spline[k]);
            slope[k].push_back(weights.slope[k]);
            bend[k].push_back(weights.bend[k]);
            colour[k].push_back(weights.colour[k]);
        }
    }
}

}  // namespace pastoso::shade
