// How smooth a straight stroke is: the slopes of its surface along the travel and across it.
#pragma once

#include "film/state.hpp"

#include <vector>

namespace pastoso::brush::studio {

/// A stroke of 34 mm in 0.6 s with a wide side across the travel, on a panel in heavy-body oil at
/// pressure 0.45, and a second of rest after it.
struct StraightStroke {
    const char* preset = "";
    double angle_deg = 0.0;  ///< of the travel against the rows of cells
    double fill = 1.0;       ///< of the brush
};

/// Slopes of the heights between cells' middles, by the cubic spline through them, rms over the inner
/// three fifths of the width from 12 to 28 mm.
struct Slopes {
    double along = 0.0, across = 0.0;
};

film::FilmState painted(const StraightStroke& stroke, double px_per_mm);

/// Of the surface as cells `block` times as wide see it, by their means.
Slopes slopes_of(const film::FilmState& film, const StraightStroke& stroke, int block = 1);

}  // namespace pastoso::brush::studio
