// The paint of a tile with two wet strata in reach, moved by a step: each stratum as paint is moved
// (tile_step.hpp), with its share of the flux.
//
// The parabolic profile of a film, zeta the height in thicknesses and alpha that of its peak,
//     u(zeta) / u = (6 alpha zeta - 3 zeta^2) / (3 alpha - 1),
// lets the upper stratum, the share s of the cell that gives, carry
//     phi(s) = 1 - (1 - s)^2 (3 alpha - 1 + s) / (3 alpha - 1)
// of the flux: more than its share, so that a run drags its skin ahead. Neither stratum gives more than
// it holds. Where they meet the shear of the step is
//     gamma = |u| dt / h (6 alpha - 6 (1 - s)) / (3 alpha - 1),
// and equal volumes m h_u (h - h_u) / h are swapped, m = gamma / (gamma + kMixingStrain).
#pragma once

#include "film/explicit/tile_update.hpp"

namespace pastoso::film {

/// The shear after which half of what can mix has mixed.
inline constexpr float kMixingStrain = 40.0F;

/// Gathers the thickness of the upper strata in and around a tile. False when there are none: then the
/// tile's paint moves as one. Two tiles that exchange paint of an upper stratum both say true.
bool gather_strata(const FilmState& state, const TilePlace& place, const HaloBlock& block,
                   StrataScratch& upper);

/// Fills the paint, what becomes of the lower stratum, and the runoff of `result`, whose new thickness
/// is known, after gather_strata(). Uses up the fluxes of the worker's scratch.
void move_strata(const FilmState& state, const TilePlace& place, const FilmProfile& profile,
                 WorkerScratch& worker, TileResult& result);

/// Sets cells of a tile. Several threads may do so, in tiles of their own.
void change_lower(LowerStratum& lower, int tile, std::span<const LowerChange> changes);

}  // namespace pastoso::film
