// Concentrations of what a tile's paint carries, of the tile and two cells around it: what the pigment
// transport of a tile reads.
#pragma once

#include "film/explicit/halo_block.hpp"
#include "film/explicit/tile_step.hpp"

#include <vector>

namespace pastoso::film {

/// What is gathered, each kConcentrationCount floats (concentration_index): the concentrations of the
/// lower stratum and of the upper one where fluxes read them; without `upper`, of all paint in `lower`.
struct Concentrations {
    float* lower;
    float* upper = nullptr;
    const ReadCells* read = nullptr;
    std::int32_t largest = 0;  ///< amount that any channel holds
};

/// Fills them; places beyond open edges get 0.
void gather_concentrations(const FilmState& state, const HaloMap& columns, const HaloMap& rows,
                           int tile_x, Concentrations& out);

/// Fills `held` with what the tile and one cell around it carry (held_index).
void gather_held(const FilmState& state, const HaloMap& columns, const HaloMap& rows,
                 std::vector<PaintCell>& held);

}  // namespace pastoso::film
