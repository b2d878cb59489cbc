// Dry paint that comes off again: wet paint dissolves the soluble stratum below it.
#pragma once

#include "core/thread_pool.hpp"
#include "film/state.hpp"
#include "grid/mask.hpp"

namespace pastoso::film {

/// Pure solvent takes up all but 1/e of a soluble stratum in this time.
inline constexpr double kDissolvingTime_s = 20.0;

/// Moves the share 1 - e^(-seconds w / kDissolvingTime_s) of every cell's soluble stratum into the wet
/// paint above it, w = 1 - h_solid / h being the share of solvent in that. Whole quanta of thickness and
/// pigment move, the support sinks by what leaves it, and the surface of the paint stays where it is.
/// The dissolved solids do not change the amounts of viscosity, yield stress and drying time. Nothing
/// moves in the cells of `cover`.
void dissolve(FilmState& state, double seconds, core::ThreadPool& pool,
              const grid::Mask* cover = nullptr);

}  // namespace pastoso::film
