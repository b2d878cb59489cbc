// Layers on a canvas that has been cut or made larger.
#pragma once

#include "film/state.hpp"
#include "grid/extent.hpp"
#include "layers/apart.hpp"

namespace pastoso::layers {

/// What lies on a layer, apart from what it lies on, cell by cell in its new place; what the new canvas
/// does not reach is gone, and of fixed paint its share by relief (cutting.hpp). Paint begins at rest.
/// What has evaporated is unchanged.
film::FilmState on_extent(const film::FilmState& layer, const grid::Extent& extent);

/// Heights of a support, the outermost ones going on beyond the edges.
Heights widened(const Heights& heights_mm, const grid::Extent& extent);

}  // namespace pastoso::layers
