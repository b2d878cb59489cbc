// Viscosity and yield stress of every cell of a tile and around it, from what its paint carries.
#pragma once

#include "film/explicit/halo_block.hpp"
#include "film/explicit/tile_step.hpp"

namespace pastoso::film {

/// Fills block.viscosity and block.yield for the cells -1..64 of both axes, which the faces of the tile
/// look at. Dry cells get those of kThinnest_m2_s without yield stress.
void gather_rheology(const FilmState& state, const HaloMap& columns, const HaloMap& rows, int tile_x,
                     float yield_per_Pa, CellRheology rheology, HaloBlock& block);

}  // namespace pastoso::film
