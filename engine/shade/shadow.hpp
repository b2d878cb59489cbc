// Cast shadows of the relief.
#pragma once

#include "film/state.hpp"
#include "shade/render.hpp"
#include "shade/surface.hpp"

namespace pastoso::shade {

/// The height in mm below which the light does not reach, over each cell of a rectangle:
///
///     S(p) = max over t > 0 of h(p + t d) - t tan(elevation),    d: towards the light, unit length
///
/// or what the light drops over one line of cells below the lowest height of the canvas where that is
/// higher: beside a shadow S goes on falling, so that between the cells it is told where it ends. The
/// surface itself is compared with S only where the picture is sampled, so that the shadow's edge
/// follows the interpolated surface and not the cells. The maximum is taken over the lines of cells that
/// cross d, between whose cell means h is interpolated linearly, as far as a shadow within `range` can
/// reach; `range` is that of the whole canvas. `stride` floats from row to row.
void shadow_heights(const film::FilmState& film, const grid::Rect& cells, const Lighting& lighting,
                    const HeightRange& range, float* out, int stride);

}  // namespace pastoso::shade
