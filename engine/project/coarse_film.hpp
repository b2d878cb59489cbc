// A film of fewer cells that looks alike, for pictures that are smaller than the canvas.
#pragma once

#include "core/thread_pool.hpp"
#include "film/state.hpp"

namespace pastoso::project {

/// Every cell is the mean of factor x factor cells, of those on the canvas: wet and dry paint and the
/// support; nothing moves. `factor` is a power of two up to 64.
film::FilmState coarse_film(const film::FilmState& film, int factor, core::ThreadPool& pool);

}  // namespace pastoso::project
