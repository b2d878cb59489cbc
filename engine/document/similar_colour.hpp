// Where a painting has nearly the colour of a place.
#pragma once

#include "core/thread_pool.hpp"
#include "document/actions/selection_actions.hpp"
#include "film/state.hpp"
#include "pigment/bands.hpp"

namespace pastoso::document {

/// `seen` is all that is visible, on this ground (Snapshot). Colours are those of the paint under even
/// daylight (shade/tile_colour.hpp), beside titanium white.
grid::Mask area_of(const SelectSimilarColour& select, const film::FilmState& seen,
                   const pigment::Bands& ground, core::ThreadPool& pool);

}  // namespace pastoso::document
