// Small pictures of what a tool does, and of what a medium is like, painted by the engine itself.
#pragma once

#include "brush/preset.hpp"
#include "core/thread_pool.hpp"
#include "film/medium.hpp"
#include "shade/render.hpp"

namespace pastoso::document {

/// A stroke of the tool on white board, `width_px` by `height_px`, about four widths of the tip across:
/// brushes and knives loaded with blue, tools that take up, move or blow paint in wet paint. Always the
/// same for the same preset.
pigment::Image8 thumbnail(const brush::Preset& preset, int width_px, int height_px,
                          core::ThreadPool& pool);

/// A stroke of red and two drops in the bundled medium of that name, on a board of which the right half
/// is black, and stood up for some seconds: ridges and levelling, drips, how much of the ground it lets
/// through. A medium without solids drops clear on red linseed oil.
pigment::Image8 thumbnail(const film::Medium& medium, int width_px, int height_px,
                          core::ThreadPool& pool);

}  // namespace pastoso::document
