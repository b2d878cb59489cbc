// Paint that leaves a tool by itself: what overflows is pushed aside, what a lifted knife leaves behind
// stays as a ridge.
#pragma once

#include "brush/bristle_motion.hpp"
#include "brush/brush.hpp"
#include "brush/cell_batch.hpp"
#include "brush/hand_pose.hpp"
#include "brush/media_exchange.hpp"
#include "film/state.hpp"

namespace pastoso::brush {

/// Puts `volume_mm3` of the held paint (19/20 of it at most) onto the film as a heap 1 - (d / spread)^2
/// around a place, widened by what a cell adds to it (brush/cell_mean.hpp). What falls beyond the canvas
/// stays in the tool. Returns the cells that may have changed. `media` as of apply().
grid::Rect put_down(Contents& held, double volume_mm3, double x_mm, double y_mm, double spread_mm,
                    std::uint32_t dither_seed, film::FilmState& film, CellBatch& scratch,
                    MediaExchange* media = nullptr);

/// Wet paint at a place, or at the nearest one on the canvas.
double thickness_at(const film::FilmState& film, double x_mm, double y_mm);

/// Where a heap goes that is pushed out sideways, and how wide it gets.
struct HeapPlace {
    double x_mm, y_mm, spread_mm;
};

/// A heap at least `least_mm` wide whose near side lies `beside_mm` from a place, in the direction of
/// the unit vector `away`. The wider paint is heaped there already, the wider it spreads, which keeps
/// ridges below 45 degrees.
HeapPlace place_beside(const film::FilmState& film, double x_mm, double y_mm, double away_x,
                       double away_y, double beside_mm, double least_mm);

/// What all bristles have in common when they spill.
struct SpillRates {
    double radius_mm = 0.4;  ///< of a bristle's footprint
    double step_mm = 0.1;
    std::uint32_t jitter_seed = 0;  ///< chooses the side that an inner bristle spills to
};

/// Lets a bristle that holds more than the preset's overflow push the surplus out, at right angles to
/// its travel. Bristles heap it up beside themselves, those along the edges of the stroke inwards, so
/// that no halo is left on wet paint; a knife beyond its nearer end, or beyond the trailing one if it is
/// held aslant, where it stays as a ridge. Returns the cells that may have changed.
grid::Rect spill_overflow(Brush& brush, int bristle, const BristlePose& pose, const HandPose& hand,
                          const Swath& swath, const SpillRates& rates, std::uint32_t dither_seed,
                          film::FilmState& film, CellBatch& scratch, MediaExchange* media);

}  // namespace pastoso::brush
