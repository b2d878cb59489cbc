// The primitive forms of a scene's film as means over cells.
#pragma once

#include "film/laboratory/scene.hpp"

namespace pastoso::film {

/// The cells of the canvas that a form may reach.
grid::Rect reach_of(const Form& form, grid::Shape shape, double cell_mm);

/// The mean thickness over cell (x, y), mm. Not for a GreyMap, which is resampled as a whole, nor for
/// CellValues, which need no mean.
double mean_thickness_mm(const Primitive& primitive, int x, int y, double cell_mm);

}  // namespace pastoso::film
