// A film of fewer cells that looks alike, for pictures that are smaller than the canvas.
#pragma once

#include "core/thread_pool.hpp"
#include "film/state.hpp"
#include "pigment/bands.hpp"

namespace pastoso::project {

/// Every cell is the mean of factor x factor cells, of those on the canvas: wet and dry paint, support
/// and ground; nothing moves. `factor` is a power of two up to 64; where the ground is background it is
/// `bare_ground`.
film::FilmState coarse_film(const film::FilmState& film, int factor, const pigment::Bands& bare_ground,
                            core::ThreadPool& pool);

}  // namespace pastoso::project
