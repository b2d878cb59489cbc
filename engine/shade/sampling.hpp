// Where the picture's samples lie on the cells, and with what weights the cells around enter.
#pragma once

#include "shade/tile_colour.hpp"

#include <array>
#include <cstdint>
#include <vector>

namespace pastoso::shade {

/// Weights of the four cells around a point along one axis.
struct AxisWeights {
    std::array<float, 4> spline;  ///< of B-spline coefficients (grid/bspline.hpp)
    std::array<float, 4> slope;   ///< of their derivative, per cell
    std::array<float, 4> bend;    ///< of its derivative, per cell^2
    std::array<float, 4> colour;  ///< of cell colours: colour_weights()
};

/// Weights for colours, `t` as in grid::bspline_weights(). Sharpness 1 is the cubic of Mitchell and
/// Netravali (1988) with B = C = 1/3, which keeps the finest strokes crisp and is nearly free of halos;
/// sharpness 0 is the B-spline, in which edges show no steps of the cells however far they are enlarged;
/// between them a blend. All are at least once continuously differentiable and have the sum 1.
std::array<float, 4> colour_weights(float t, float sharpness);

/// 1 up to a pixel per cell, falling to 0 at four pixels per cell, where the eye begins to see single
/// cells.
float colour_sharpness(double scale);

/// The samples along one axis: sample i uses the cells first_cell[i] ... + 3 of the layers.
struct SampleAxis {
    std::vector<int> first_cell;
    std::vector<AxisWeights> weights;
};

/// Samples that lie at origin + (j + 1/2) spacing, in cells.
struct SampleGrid {
    double origin = 0.0, spacing = 1.0;
    float sharpness = 1.0F;  ///< of the colours
};

/// The samples j = first ... first + count - 1; first_cell counts from `layer_origin`.
SampleAxis sample_axis(const SampleGrid& samples, int first, int count, int layer_origin);

/// A SampleAxis for the vectorised loop along a row: one array per weight.
struct SampleColumns {
    explicit SampleColumns(const SampleAxis& axis);

    int count = 0;
    std::vector<int> first_cell;
    std::array<std::vector<float>, 4> spline, slope, bend, colour;
};

/// The most cells that the samples of one row may span.
inline constexpr int kMaxRowCells = 160;

/// Four neighbouring rows of each layer (cell_layers.hpp).
struct LayerRows {
    std::array<const float*, 4> height, shadow, sky;
    std::array<const CellColour*, 4> colour;
};

/// Four neighbouring rows of the layers of an outline (outline_layers.hpp).
struct OutlineRows {
    std::array<const float*, 4> share, sharp, cover, support;
    std::array<const CellColour*, 4> covered, dry;
    const std::uint8_t* near;  ///< of the first row
};

}  // namespace pastoso::shade
