// Two layers made one, without a loss of paint.
#pragma once

#include "core/thread_pool.hpp"
#include "film/state.hpp"

namespace pastoso::layers {

/// The layer `upper` on the layer `lower` (both apart from what they lie on). Cell by cell:
/// - Where wet paint of the upper layer lies directly on wet paint, the two run together; where they are
///   more than a cell holds, the lower one is dry first.
/// - Wet paint of the lower layer is dry below anything dry of the upper one, and a stratum of it that
///   could be dissolved is sealed.
/// - A layer with an opacity below 1 is dry when it is merged: what it does to light is then all that is
///   left to fade.
/// Volumes and pigments of wet and dry paint and what has evaporated are in all what they were in both.
/// Merged paint begins at rest.
film::FilmState merged(const film::FilmState& lower, const film::FilmState& upper, double upper_opacity,
                       core::ThreadPool& pool);

}  // namespace pastoso::layers
