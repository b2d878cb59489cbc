// The surface that a field at cells' middles stands for: the zero of a continuous interpolant. Positions
// are in cell units, values in cells' sides (phi / cell_m), slopes are plain numbers.
#pragma once

#include "grid/box_field.hpp"

#include <glm/vec3.hpp>

namespace pastoso::tank {

struct Interpolated {
    float value;
    glm::vec3 slope;
};

/// Trilinear between the eight nearest middles, less t (1 - t) / 2 times a limited second difference
/// along each axis: the harmonic mean of those at both ends of an edge, 0 where they differ in sign (t:
/// how far along the edge; the four edges along an axis are mixed bilinearly). Fourth order in the
/// middle of edges where the field is smooth; linear next to a kink, so that the two sides of a thin
/// sheet do not move each other. Beyond the box the field goes on straight, if its two samples there do
/// (continue_beyond_walls); places more than eight cells beyond are put there.
Interpolated interpolate(const grid::BoxField& phi, const glm::vec3& place_cells);

struct Foot {
    glm::vec3 place_cells;
    bool found;  ///< false: the search ended off the surface
};

/// The point of the surface that is closest to a place, sought from another one near the surface by
/// Chopp's iteration (SIAM J. Sci. Comput. 23, 2001), which goes to the surface along the slope and
/// beside it towards the place; how far beside it is learnt from move to move (secant).
Foot find_foot(const grid::BoxField& phi, const glm::vec3& place_cells, const glm::vec3& start_cells);

}  // namespace pastoso::tank
