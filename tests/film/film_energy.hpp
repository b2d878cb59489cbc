// The discrete energy whose loss is the drag's work: what a film without forcing may never gain.
#pragma once

#include "film/film_bench.hpp"

#include <vector>

namespace pastoso::film::test {

/// Heights and velocities of a film without the solver's rounding.
struct FilmSnapshot {
    explicit FilmSnapshot(const Bench& bench);
    std::vector<double> thickness, surface;  ///< mm; the surface from its mean
    std::vector<double> velocity_x, velocity_y;
};

/// Gravity's and the surface's energy for small slopes, per density and cell area, mm3/s2:
///     sum over cells of g eta_a eta_b / 2 + sum over faces of sigma/rho (d eta_a/dx) (d eta_b/dx) / 2.
/// With a = b it is the energy of one surface.
double potential_energy(const Bench& bench, const FilmSnapshot& a, const FilmSnapshot& b);

/// Sum over faces of h u^2 / 2 with the mean h of both cells, in the same unit.
double kinetic_energy(const Bench& bench, const FilmSnapshot& film);

}  // namespace pastoso::film::test
