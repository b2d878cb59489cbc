// A mask as it lies in a project file, row by row: a bit for every cell of the canvas, the first one the
// lowest of its byte; where it has soft edges a byte, the share of the cell as grid::Mask has it.
#pragma once

#include "grid/mask.hpp"
#include "packing/packed_bytes.hpp"

namespace pastoso::project {

/// Of a mask without soft edges, and of one with them.
std::size_t mask_bytes(grid::Shape shape);
std::size_t soft_mask_bytes(grid::Shape shape);

/// One or the other, by grid::is_soft().
packing::Bytes mask_content(const grid::Mask& mask);

/// The other way round; there are mask_bytes() or soft_mask_bytes() of them. A canvas of one cell has no
/// soft mask.
grid::Mask mask_of_content(grid::Shape shape, std::span<const std::byte> content);

}  // namespace pastoso::project
