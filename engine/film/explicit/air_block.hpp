// What a tile's block feels of a jet of air.
#pragma once

#include "film/air_jet.hpp"
#include "film/explicit/halo_block.hpp"

#include <span>

namespace pastoso::film {

/// Fills block.air with the sum of p/rho, mm2/s2, of every cell of the block and sets block.pressed;
/// clears that where nothing of the jets is felt. `columns` and `rows` are those that the block was
/// gathered with.
void press(std::span<const AirJet> jets, double density_kg_m3, const HaloMap& columns,
           const HaloMap& rows, double cell_mm, HaloBlock& block);

}  // namespace pastoso::film
