// Concentrations of what a tile's paint carries, of the tile and two cells around it: what the pigment
// transport of a tile reads.
#pragma once

#include "film/halo_block.hpp"
#include "film/tile_step.hpp"

namespace pastoso::film {

/// Fills `out` (kConcentrationCount floats, concentration_index); places beyond open edges get 0.
void gather_concentrations(const FilmState& state, const HaloMap& columns, const HaloMap& rows,
                           int tile_x, Concentrate concentrate, float* out);

}  // namespace pastoso::film
