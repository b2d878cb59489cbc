// The symmetric matrix that pressure and implicit diffusion have in common:
//     (A p)_c = sum over the cell's faces of a_f (p_c - p_neighbour) + (d_c + m_c) p_c.
#pragma once

#include "liquid/flow/velocity.hpp"

namespace pastoso::liquid {

/// Coefficients are >= 0 and without unit. A cell whose coefficients are all 0 takes no part: its value
/// stays 0. Faces of the box itself must be 0, as must those between a cell that takes part and one that
/// does not (their place is in `boundary`).
struct CellMatrix {
    VelocityField faces;      ///< a_f of each face
    grid::BoxField boundary;  ///< d_c: faces beyond which the value is given (air, a moving wall)
    grid::BoxField mass;      ///< m_c: 1 for implicit diffusion, 0 for a pressure

    CellMatrix() = default;
    explicit CellMatrix(const grid::BoxShape& shape) : faces(shape), boundary(shape), mass(shape) {}
    const grid::BoxShape& shape() const { return faces.shape(); }

    /// The factor of p_c in its own equation.
    float diagonal(int i, int j, int k) const {
        return ((faces.x.at(i, j, k) + faces.x.at(i + 1, j, k)) +
                (faces.y.at(i, j, k) + faces.y.at(i, j + 1, k)) +
                (faces.z.at(i, j, k) + faces.z.at(i, j, k + 1))) +
               (boundary.at(i, j, k) + mass.at(i, j, k));
    }
};

}  // namespace pastoso::liquid
