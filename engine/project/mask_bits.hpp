// A mask as it lies in a project file: a bit for every cell of the canvas, row by row, the first one the
// lowest of its byte.
#pragma once

#include "grid/mask.hpp"
#include "packing/packed_bytes.hpp"

namespace pastoso::project {

std::size_t mask_bytes(grid::Shape shape);

packing::Bytes mask_bits(const grid::Mask& mask);

/// The other way round; there are mask_bytes(shape) of them.
grid::Mask mask_of_bits(grid::Shape shape, std::span<const std::byte> bits);

}  // namespace pastoso::project
