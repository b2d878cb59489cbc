// A choice of cells made wider or narrower by a distance, the same in every direction. A cell is chosen
// from one half on; what comes of it has no soft edges.
#pragma once

#include "grid/mask.hpp"

namespace pastoso::grid {

// The outline of a choice runs half a cell beyond the centres of its outermost cells: a cell lies within
// `reach` cells of it when its centre is at most reach + 1/2 from that of a chosen cell, by Euclid and
// exactly (Meijster, Roerdink, Hesselink: A general algorithm for computing distance transforms in
// linear time, 2000, of which a fixed reach needs no more than the first pass and a sum over each row).
// Cells beyond the canvas are neither chosen nor not: its edge is no outline. `reach` is finite and not
// negative.

/// What is chosen, and all that lies within the reach of it.
Mask grown(const Mask& mask, double reach);

/// What is chosen, but for what lies within the reach of the others.
Mask shrunk(const Mask& mask, double reach);

/// What lies within the reach of the outline, on both sides of it.
Mask along_outline(const Mask& mask, double reach);

}  // namespace pastoso::grid
