// How much milk lies in the way of light: what a quick picture shades milk by.
#pragma once

#include "grid/box_field.hpp"

#include <glm/vec3.hpp>

namespace pastoso::liquid {

/// A field of half as many cells along each side, which must be even: the means of eight.
grid::BoxField halved(const grid::BoxField& field);

/// At the middle of each cell the integral of `share` straight along `way` (of any length, upwards) to
/// the end of the box, in metres:
///     D(x) = D(x + h w / w_z) + (s(x) + s(x + h w / w_z)) / 2 h |w| / w_z,
/// from the uppermost layer of cells down, h a cell's side; bilinear in each layer, and 0 beyond the
/// box. The ghosts are 0.
grid::BoxField milk_depth_m(const grid::BoxField& share, const glm::vec3& way);

}  // namespace pastoso::liquid
