// A choice of cells with a soft edge.
#pragma once

#include "grid/mask.hpp"

namespace pastoso::grid {

/// Shorter reaches, in cells, change nothing.
inline constexpr double kLeastFeather = 1.5;

/// The mean of the shares around every cell, with the weight of a quadratic B-spline along each axis: of
/// three boxes, each 2/3 `reach` cells wide, one after the other. A straight edge becomes a smooth slope
/// that begins and ends `reach` cells on either side of it, and is one half where the edge was. Whole
/// numbers only, so mirrored masks give mirrored ones. Beyond the canvas its outermost cells go on: its
/// edge is none of the mask. `reach` is finite and not negative.
Mask feathered(const Mask& mask, double reach);

}  // namespace pastoso::grid
