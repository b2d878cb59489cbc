// The smooth surface through cell means: cubic B-splines, twice continuously differentiable, so that shading
// shows neither cells nor seams at any zoom (docs/decisions, film design section 6).
#pragma once

#include <array>

namespace pastoso::grid {

/// Weights of the four coefficients around a point, and those of the first and second derivative. `t` in
/// [0, 1) is the point's distance from the second coefficient, in cells: s(x) = sum_k weight[k] c[i - 1
/// + k], x = i + t.
struct BsplineWeights {
    std::array<float, 4> value;
    std::array<float, 4> slope;  ///< d/dx, per cell
    std::array<float, 4> bend;   ///< d2/dx2, per cell^2
};
BsplineWeights bspline_weights(float t);

/// Half width of the prefilter's stencil.
inline constexpr int kPrefilterReach = 2;

/// Weights of the 5-tap prefilter that turns cell means m into B-spline coefficients along one axis,
/// c = (1 - 5/24 d2 + 47/1152 d4) m with the central differences d2 and d4 = d2 d2. The means of the spline
/// over the cells equal m to sixth order: the cell mean of a cubic B-spline has the symbol
/// 1 + 5/24 d2 + 1/384 d4, whose inverse this is up to d4.
inline constexpr std::array<float, 5> kPrefilterTaps = {
    47.0F / 1152.0F,
    -5.0F / 24.0F - 4.0F * 47.0F / 1152.0F,
    1.0F + 2.0F * 5.0F / 24.0F + 6.0F * 47.0F / 1152.0F,
    -5.0F / 24.0F - 4.0F * 47.0F / 1152.0F,
    47.0F / 1152.0F,
};

}  // namespace pastoso::grid
