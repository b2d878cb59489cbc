// The front of paint that runs down: how far it has come, how wide, how round and how thick it is.
#pragma once

#include "film/solver.hpp"

#include <optional>

namespace pastoso::film {

/// The wet outline seen along the force F in the canvas plane, with s the distance behind the tip and
/// w(s) the width of the wet area across. Cells count as wet in proportion to h / h_edge up to 1, with
/// h_edge a tenth of the largest thickness, so that thin trails do not count.
struct Front {
    double tip_mm = 0.0;    ///< position of the foremost wet point along F, from the upper left corner
    double width_mm = 0.0;  ///< W, the largest w(s)
    /// R of the circle through the tip, (w/2)^2 + s^2 = 2 R s, that fits the foremost quarter of W best.
    double radius_mm = 0.0;
    double roundness =
        0.0;  ///< 2 R / W: 1 for a strip with a semicircle as its end, less where it tapers
    /// Wet area within W/2 behind the tip over that of the semicircle, pi W^2 / 8: 1 for a semicircle,
    /// 0.64 for a triangle, 1.27 for a square end.
    double fullness = 0.0;
    double thickness_mm = 0.0;  ///< the largest within W/2 behind the tip
};

/// Nothing without paint, without a force along the canvas, or for a front too small to fit (W below 8
/// cells). Paint that has run through a periodic edge is not put together again.
std::optional<Front> front_of(const FilmState& film, const Gravity& gravity);

}  // namespace pastoso::film
