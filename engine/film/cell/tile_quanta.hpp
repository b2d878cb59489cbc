// Amounts of a tile, in quanta.
#pragma once

#include "grid/tile_block.hpp"

#include <algorithm>
#include <cstdint>

namespace pastoso::film {

/// A part of a cell's paint that is smaller than its 2^14th is a trace, too little to follow.
inline constexpr int kTraceBits = 14;

/// Whether any of the tile's cells has one other than 0.
inline bool any_quanta(const std::int32_t* tile) {
    return std::any_of(tile, tile + grid::kTileCells, [](std::int32_t amount) { return amount != 0; });
}

}  // namespace pastoso::film
