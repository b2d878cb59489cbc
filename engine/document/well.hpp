// The mixing well: a palette of wet paint beside the canvas, of the same paint and under the same
// solver.
#pragma once

#include "brush/contents.hpp"
#include "document/actions/well_actions.hpp"
#include "film/cell/paint_cell.hpp"
#include "film/solver.hpp"
#include "film/state.hpp"

namespace pastoso::document {

/// Whatever the canvas's resolution is, so that a mixture does not depend on it.
inline constexpr double kWellPxPerMm = 3.0;

/// Its rim keeps all paint in.
inline constexpr film::SolverOptions kWellSolving = {.edge_x = film::Edge::Wall,
                                                     .edge_y = film::Edge::Wall};

/// Smooth as glass and empty: holds no tiles.
film::FilmState bare_well();

/// Puts a dollop of paint in a medium onto the well, all of it within the rim. Returns what has come
/// out: less than `volume_mm3` where the place is full.
brush::Contents squeeze_onto(film::FilmState& well, film::Solver& solver, const film::Medium& medium,
                             const film::PaintCoefficients& paint, double volume_mm3, double x_mm,
                             double y_mm);

}  // namespace pastoso::document
