// Layers, supports and what is traced on a canvas that has been turned or mirrored as a whole.
#pragma once

#include "core/orientation.hpp"
#include "core/thread_pool.hpp"
#include "film/state.hpp"
#include "layers/apart.hpp"
#include "layers/tracing.hpp"

namespace pastoso::layers {

/// A layer on the turned canvas, to the bit: every cell has all that it had, and paint goes on as fast,
/// in the direction that has become of its own. What is turned back is as it was. (Velocities at the
/// canvas's own edges, which nothing asks for, count as those between its last cells and its first.)
film::FilmState turned(const film::FilmState& layer, const core::Orientation& turn,
                       core::ThreadPool& pool);

/// Heights in levels stay in levels, floats stay floats.
Heights turned(const Heights& heights_mm, const core::Orientation& turn, core::ThreadPool& pool);

/// The picture and its place on a canvas that was so large.
Tracing turned(const Tracing& tracing, const core::Orientation& turn, double width_mm, double height_mm);

}  // namespace pastoso::layers
