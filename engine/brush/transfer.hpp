// The two-way exchange of paint between a tip and the film, one rule for everything:
//
//   the surface of the paint is driven towards the underside of the bristle.
//
// With s the support that the bristle rides on, f = V / capacity its fill, sat = 1.22 f / (f + 0.22), p
// its pressure and rho the distance from its middle in footprint radii, a of it across the travel, the
// wanted surface is
//
//   z = s + tau + film sat^2 profile(a),    profile(a) = groove (a^2 + 1/4) + hair noise(a) as cells see
//   it, tau = film sat^2 body (1 - p/2) (1 + edge E) (1 + start sat freshness),
//
// E = 1 along the edges of the stroke under firm hairs (firmness() in bristle_motion.hpp). Its paint
// hangs down to s - bead; a cell with surface c + h is reached by
// chi = clamp((c + h - (s - bead)) / 0.4 bead), where
//
//   bead = e^2 1.2 reach film + (0.005 mm + 0.05 mm p) clamp(e / 0.2),
//   e = sat - 0.6 (1.2 - body) (1 - 0.7 sat),
//
// so that a full brush covers the hollows of the weave and a starved one, thin bristles first, only its
// crowns. In a step ds, with the weight w(rho) of the footprint (brush/resolved_tip.hpp; 1 - rho^4 where
// cells are fine), the gap g = z - c - h and the share q = (1 - e^(-ds / b r)) w chi,
// b = 0.8 for hairs and 0.25 for what is stiff,
//
//   g > 0: the cell gains q (C (z - c) - h), C the share of it that is covered (a bristle gives at most
//          half of what it holds),
//   g < 0: it loses q |g| pickup, at most nine tenths of h,
//   and equal volumes q mix (0.4 + 1.2 body) min(h, h_0, V / 2 area) are swapped,
//
// A tool that coats the grain (coat k from 0 to 1) drives the surface to z - k (s - c) instead, as thick
// a coat in a hollow as on a crown, of the share 1 - k (1 - chi) of it where it hardly reaches.
//
// h_0 being what the tip found there when it came: nothing is swapped with paint that the stroke itself
// has just laid down, which would blur its streaks.
//
// Paint that comes onto other paint which the tip found there lies above it; that is the lower stratum
// from then on, of thickness h_l (film/cell/lower_stratum.hpp). What comes later in the same pass joins
// the upper one; over two strata that were found, paint that is going to hide them, and differs from the
// upper by more than half of what they differ by, makes one of both and lies above. What is swapped
// comes from both as they lie; what is lost from the upper one first, but for the share d. Then a touch
// stirs:
//
//   equal volumes m h_l (h - h_l) / h of both strata are swapped, m = d q,
//   d = mix p for hairs, a tenth of that for what is stiff.
//
// Thixotropic paint is worked all through where it is touched (film/cell/structure.hpp).
//
// C = min(1, cover w / max(A, (1 - sat)^2)): a bristle that is alone, at the edge of its clump (A = 1
// there, brush/clumps.hpp) or with its neighbours starved, leaves in a cell the share that it covers;
// among others, they cover the rest.
//
// The elements of a knife share one s, act within lanes as wide as their distance, which keeps colours
// apart, and have e = sat, A = 0 and no grooves. With w = 1 - along^4 and v the mean of 1 - |across|
// over the width of a cell, an element's share is 1 - (1 - q)^v: where lanes overlap two of them do
// together what one does in its middle. That of a comb's teeth, which stand apart, is q v.
//
// Ridges, streaks, starved strokes, picking up and ploughing follow. Whole quanta are moved and the
// bristle gets exactly what the cells lost: tip and film together keep their volume and pigment to the
// rounding of a double.
#pragma once

#include "brush/bristle_motion.hpp"
#include "brush/brush.hpp"
#include "brush/cell_batch.hpp"
#include "brush/media_exchange.hpp"
#include "brush/resolved_tip.hpp"
#include "brush/transfer_kernels.hpp"
#include "film/state.hpp"

namespace pastoso::brush {

/// One touching bristle (or element of a knife) in one step.
struct Contact {
    double x_mm = 0.0, y_mm = 0.0;
    float support_mm = 0.0F;                ///< height of what it bears on (brush/bearing.hpp)
    float press = 0.0F;                     ///< 0 to 1
    float ride = 0.0F;                      ///< 0 to 1; what rides takes and mixes nothing
    float freshness = 0.0F;                 ///< 0 to 1
    float edge = 0.0F;                      ///< 1 at the edges of the stroke, 0 within
    float alone = 0.0F;                     ///< 1 at the edges of a clump of bristles, 0 within
    double across_x = 1.0, across_y = 0.0;  ///< unit vector along which the hairs lie side by side
};

/// Numbers that stay the same during a step.
struct StepRates {
    const ResolvedTip* tip = nullptr;
    double along_per_mm = 0.0, across_per_mm = 0.0;  ///< 1 / half sizes of its footprint
    double per_capacity_mm3 = 0.0, half_depth_mm_per_mm3 = 0.0;
    float rate = 0.0F;                                  ///< 1 - e^(-ds / 0.8 r)
    float film_mm = 0.0F, reach = 1.0F, pickup = 0.0F;  ///< the preset's, times the hand's factors
};
StepRates step_rates(const Brush& brush, const ResolvedTip& tip, const HandPose& hand, double step_mm);

/// The equations above for bristle `index`, as the kernels take them.
ExchangeRule exchange_rule(const Brush& brush, int index, const Contact& contact,
                           const StepRates& rates);

/// Fills the changes and swaps of a gathered batch. Returns their sums.
WantedSums plan_exchange(const ExchangeRule& rule, CellBatch& batch);

/// How much of what a batch plans a tool may do.
struct Limits {
    double deposit_share = 0.0;  ///< of the held volume, at most
    double swap_share = 0.0;
    float depth = 0.0F;  ///< how far down into two strata, 0 to 1
};
Limits touch_limits(const Brush& brush, const Contact& contact);

/// Scales the changes and swaps planned in `batch`, whose sums are `wanted`, to what is held, and fills
/// in what it does to its tiles.
ApplyRule apply_rule(const Limits& limits, WantedSums wanted, std::uint32_t dither_seed,
                     const film::FilmState& film, const Contents& held, CellBatch& batch);

/// Whether no other state shares the tiles that such a batch is going to change. If so, several threads
/// may apply batches of different cells at once.
bool owns_planned_tiles(const CellBatch& batch, const film::FilmState& film);

/// Makes it so, for one thread alone.
void own_planned_tiles(const CellBatch& batch, film::FilmState& film);

/// Applies the batch, and takes what the film gained from `held`, or gives it what the film lost.
/// Returns the cells that may have changed; the batch goes on holding the cells as they were. `media`
/// are those of a film of several, whose tiles are prepared for them; else null.
grid::Rect apply(const ApplyRule& rule, const CellBatch& batch, film::FilmState& film, Contents& held,
                 MediaExchange* media = nullptr);

/// All of that, for one thread alone.
grid::Rect apply_batch(CellBatch& batch, WantedSums wanted, const Limits& limits,
                       std::uint32_t dither_seed, film::FilmState& film, Contents& held,
                       MediaExchange* media = nullptr);

}  // namespace pastoso::brush
