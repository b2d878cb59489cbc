// What is measured on a film: its sums and extremes, its energies, and profiles along lines.
#pragma once

#include "film/laboratory/scene.hpp"

#include <vector>

namespace pastoso::film {

/// A thickness below 1e-4 cell sizes is negligible: the cell counts as dry, and the solver does not move
/// it.
struct Measures {
    double volume_mm3 = 0.0;  ///< cells that count as dry included
    double max_h_mm = 0.0;
    Point centroid;  ///< of the volume; not a number without paint
    Area wet_box;    ///< the smallest that holds all wet cells; not a number without any

    /// 1/2 rho sum h |u|^2 cell^2 with the depth-averaged velocity, the mean of a cell's faces.
    double kinetic_energy_J = 0.0;
    /// rho g sum (h c + h^2 / 2) cell^2 with the gravity g normal to the canvas: zero on a flat dry
    /// canvas. The work of a body force along the canvas is rho V F . (path of the centroid).
    double gravity_energy_J = 0.0;
    /// sigma sum (A(eta) - cos(theta_a) A(c)) cell^2 over wet cells, the tension of the surface less
    /// what wetting the support gives back at the advancing contact angle. A(f) = sqrt(1 + |grad f|^2),
    /// or 1 + |grad f|^2 / 2 where `full_curvature` is off; each component of |grad f|^2 is the mean
    /// over the cell's two faces, and eta falls to the support in dry neighbours. Of a cell that the
    /// film ends in, the part that it covers counts, with the slope of the contact line (FilmEnd).
    double surface_energy_J = 0.0;
};

/// Positions are plain canvas coordinates, also through periodic edges.
Measures measure(const FilmState& film, const Medium& medium, const Gravity& gravity,
                 const SolverOptions& options);

/// The film at one cell of a line.
struct ProfilePoint {
    double along_mm = 0.0;  ///< x of a line along x, y of one along y, of the cell's centre
    double support_mm = 0.0;
    double thickness_mm = 0.0;
    double velocity_x_mm_s = 0.0, velocity_y_mm_s = 0.0;  ///< depth means
};

/// The line y = at_mm, or x = at_mm: linear between the two nearest rows (columns) of cell centres, the
/// outermost beyond them.
enum class Axis { X, Y };
std::vector<ProfilePoint> profile_along(Axis axis, double at_mm, const FilmState& film,
                                        const SolverOptions& options);

}  // namespace pastoso::film
