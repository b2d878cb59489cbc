// A cell of a layer divided in two along a soft edge.
#pragma once

#include "film/state.hpp"
#include "grid/mask.hpp"

namespace pastoso::layers {

/// What is to be kept of a cell: its share, or what that leaves.
struct CellShare {
    std::uint8_t share;  ///< as grid::Mask has it
    bool rest;
};

/// Leaves no more in a cell of a layer. A share and its rest are together what was there, to the
/// quantum: wet paint by its thickness, the share rounded down, and whatever it carries in proportion;
/// its lower stratum goes with it in proportion, or is mixed in where nothing of it is left, or of the
/// upper one. Dry paint by whole steps of its relief, the share rounded down. What fixed paint does to
/// light is faded to the share, and to the rest. Fixed paint in all is not counted anew.
void keep_share(int tile, int cell, const CellShare& kept, film::FilmState& layer);

}  // namespace pastoso::layers
