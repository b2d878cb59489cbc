// The part of a choice of cells that hangs together.
#pragma once

#include "grid/mask.hpp"

namespace pastoso::grid {

/// The chosen cells to which steps from side to side lead from the cell (x, y) over chosen cells alone;
/// none where that one, which lies on the canvas, is not chosen.
Mask connected(const Mask& mask, int x, int y);

}  // namespace pastoso::grid
