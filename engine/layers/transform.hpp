// Moving, turning, scaling and distorting all that lies on a layer.
#pragma once

#include "core/thread_pool.hpp"
#include "film/state.hpp"
#include "grid/mask.hpp"
#include "layers/projective.hpp"

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

/// A place on the canvas.
struct Place {
    double x_mm = 0.0, y_mm = 0.0;
    friend bool operator==(const Place&, const Place&) = default;
};

/// A rectangle of the canvas is drawn by its corners, and all that is straight stays so: skewed and in
/// perspective. What lies beside the rectangle follows.
struct Distortion {
    Place corner;  ///< the upper left one of the rectangle
    double width_mm = 1.0, height_mm = 1.0;
    Place upper_left, upper_right, lower_right, lower_left;  ///< where its corners come to
    friend bool operator==(const Distortion&, const Distortion&) = default;
};

/// Clockwise, in cells.
Corners corners_in_cells(const Distortion& distortion, double cell_mm);

/// Where the cells of a canvas come to. A scale is not 0, and a distortion's corners bend outwards
/// (bends_outwards()).
Projective in_cells(const Transform& transform, double cell_mm);
Projective in_cells(const Distortion& distortion, double cell_mm);

/// What lies on a layer somewhere else on the same canvas (resampling.hpp).
///
/// The rule of volume: paint keeps its thickness. Where a layer is moved or turned its volume stays; one
/// that is scaled has its volume times scale_x scale_y, one that is distorted, in each place, its volume
/// times how its area has grown there. Moves by whole cells, mirroring and quarter turns that bring
/// cells onto cells are exact.
film::FilmState transformed(const film::FilmState& layer, const Projective& map_cells,
                            core::ThreadPool& pool);

/// The cells whose middles come from chosen ones.
grid::Mask transformed(const grid::Mask& mask, const Projective& map_cells);

}  // namespace pastoso::layers
