// The mixing well: a palette of wet paint beside the canvas, of the same paint and under the same
// solver.
#pragma once

#include "brush/contents.hpp"
#include "core/thread_pool.hpp"
#include "film/cell/paint_cell.hpp"
#include "film/medium.hpp"
#include "film/solver.hpp"
#include "film/state.hpp"

namespace pastoso::document {

inline constexpr double kWellWidth_mm = 120.0;
inline constexpr double kWellHeight_mm = 90.0;

/// Whatever the canvas's resolution is, so that a mixture does not depend on it.
inline constexpr double kWellPxPerMm = 3.0;

inline constexpr double kLeastSqueeze_mm3 = 1.0;
inline constexpr double kMostSqueeze_mm3 = 5000.0;

/// Smooth as glass and empty: holds no tiles.
film::FilmState bare_well();

/// Lies flat, and its rim keeps all paint in. The solver holds on to the film.
struct Well {
    Well(const film::Medium& medium, core::ThreadPool& pool);
    Well(const Well&) = delete;
    Well& operator=(const Well&) = delete;

    film::FilmState film;
    film::Solver solver;
};

/// Puts a dollop of paint of these coefficients onto the well, all of it within the rim. Returns what
/// has come out: less than `volume_mm3` where the place is full.
brush::Contents squeeze_onto(Well& well, const film::PaintCoefficients& paint, double volume_mm3,
                             double x_mm, double y_mm);

}  // namespace pastoso::document
