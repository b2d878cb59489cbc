// Moving, turning and scaling all that lies on a layer.
#pragma once

#include "core/thread_pool.hpp"
#include "film/state.hpp"
#include "grid/mask.hpp"

namespace pastoso::layers {

/// A point p of the canvas comes to
///
///     centre + move + R(turn) diag(scale) (p - centre),
///
/// R turning clockwise as the canvas is seen (x right, y down). A negative scale mirrors.
struct Transform {
    double centre_x_mm = 0.0, centre_y_mm = 0.0;
    double move_x_mm = 0.0, move_y_mm = 0.0;
    double turn_deg = 0.0;
    double scale_x = 1.0, scale_y = 1.0;  ///< not 0
    friend bool operator==(const Transform&, const Transform&) = default;
};

/// What lies on a layer somewhere else on the same canvas (resampling.hpp).
///
/// The rule of volume: paint keeps its thickness. Where a layer is moved or turned its volume stays; one
/// that is scaled has its volume times scale_x scale_y. Moves by whole cells, mirroring and quarter
/// turns that bring cells onto cells are exact.
film::FilmState transformed(const film::FilmState& layer, const Transform& transform,
                            core::ThreadPool& pool);

/// The cells whose middles come from chosen ones.
grid::Mask transformed(const grid::Mask& mask, double cell_mm, const Transform& transform);

}  // namespace pastoso::layers
