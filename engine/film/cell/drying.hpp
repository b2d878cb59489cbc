// Drying: wet paint gives off its solvent, stiffens, and becomes part of what lies below.
//
// A cell of paint that still needs the time t until it is touch-dry, after the time dt in moving air of
// drying rate r:
//     t' = t - r dt,
//     h' = h - (h - h_solid) r dt / t             the solvent is gone when the paint is dry,
//     nu' = nu (t / t')^2,                        Maron and Pierce's law: nu_0 (1 - s)^-2 at dryness s,
//     tau_y' = tau_y + 250 Pa s/m2 (nu' - nu)     the ratio of yield stress to viscosity in real paints,
// at most 10^4 m2/s and 1000 Pa, which stands still at any thickness. t is in proportion to the
// thickness and mixes by volume: thin paint dries first, fresh paint and thinner keep a mixture open.
// When t' <= 0 the cell is dry: its solids become support and its pigment a stratum (strata.hpp). What
// has left and what has stayed is counted in whole quanta.
#pragma once

#include "core/thread_pool.hpp"
#include "film/cell/drying_air.hpp"
#include "film/state.hpp"
#include "grid/mask.hpp"

namespace pastoso::film {

/// Lets paint dry that lies in still air of speed 1 for `seconds`, or faster under the fan; but for that
/// of the cells of `cover`.
void dry(FilmState& state, const DryingAir& air, double seconds, core::ThreadPool& pool,
         const grid::Mask* cover = nullptr);

/// Makes all wet paint dry at once, its solvent gone; or that of the cells of a mask alone.
void dry_now(FilmState& state, core::ThreadPool& pool, const grid::Mask* only = nullptr);

}  // namespace pastoso::film
