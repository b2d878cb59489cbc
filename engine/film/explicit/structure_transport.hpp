// The worked part of a tile's paint (film/cell/structure.hpp), moved and added to by a step: each cell
// gives of it what it gives of all its paint, and the shear of the step works what has rested,
//
//     h - b -> (h - b) / (1 + k + k^2/2),    k = gamma / gamma_b,
//     gamma = |u| dt / h (6 alpha - 3) / (3 alpha - 1),
//
// the mean shear over the depth of the parabolic profile (strata_transport.hpp). The fraction stands for
// e^-k, to the second order in the step.
#pragma once

#include "film/explicit/tile_update.hpp"

namespace pastoso::film {

/// Gathers the worked paint in and around a tile. False when there is none.
bool gather_worked(const FilmState& state, const TilePlace& place, BlockArray<std::int32_t>& worked);

/// The worked paint after a step whose fluxes are in the worker's scratch, where the new thickness is
/// known.
grid::TileBlock<std::int32_t> moved_structure(const FilmState& state, const TilePlace& place,
                                              const StepConstants& step, const FilmProfile& profile,
                                              const std::int32_t* thickness_after,
                                              WorkerScratch& worker);

}  // namespace pastoso::film
