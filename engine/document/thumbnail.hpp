// A small picture of what a tool does, painted by the engine itself.
#pragma once

#include "brush/preset.hpp"
#include "core/thread_pool.hpp"
#include "shade/render.hpp"

namespace pastoso::document {

/// A stroke of the tool on white board, `width_px` by `height_px`, about four widths of the tip across:
/// brushes and knives loaded with blue, tools that take up, move or blow paint in wet paint. Always the
/// same for the same preset.
pigment::Image8 thumbnail(const brush::Preset& preset, int width_px, int height_px,
                          core::ThreadPool& pool);

}  // namespace pastoso::document
