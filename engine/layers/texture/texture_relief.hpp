// A texture as thickness on a canvas.
#pragma once

#include "core/thread_pool.hpp"
#include "grid/mask.hpp"
#include "grid/tiled_field.hpp"
#include "layers/texture/texture_heights.hpp"

#include <cstdint>

namespace pastoso::layers {

/// Means over the cells of a rectangle, of whatever texture.
CellHeights texture_heights(const Texture& texture, const grid::Rect& cells, double cell_mm);

/// The thickness in each cell of the mask, null: of the whole canvas; rounded to whole quanta of what
/// paint carries, so that paste which does not shrink keeps its thickness to the quantum when it dries.
grid::TiledField<std::int32_t> texture_relief(const Texture& texture, grid::Shape shape, double cell_mm,
                                              const grid::Mask* where, core::ThreadPool& pool);

}  // namespace pastoso::layers
