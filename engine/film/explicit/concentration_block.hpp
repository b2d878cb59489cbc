// Concentrations of what a tile's paint carries, of the tile and two cells around it: what the pigment
// transport of a tile reads.
#pragma once

#include "film/explicit/halo_block.hpp"
#include "film/explicit/tile_step.hpp"

#include <vector>

namespace pastoso::film {

/// Fills `out` (kConcentrationCount floats, concentration_index); places beyond open edges get 0.
/// Returns the largest amount that any channel of them holds.
std::int32_t gather_concentrations(const FilmState& state, const HaloMap& columns, const HaloMap& rows,
                                   int tile_x, Concentrate concentrate, float* out);

/// Fills `held` with what the tile and one cell around it carry (held_index).
void gather_held(const FilmState& state, const HaloMap& columns, const HaloMap& rows,
                 std::vector<PaintCell>& held);

}  // namespace pastoso::film
