// The pressure that makes a velocity in a walled vessel free of divergence:
//     sum over a cell's faces of w u = 0,   u -= grad p,
// with w the open share of each face. The pressure is kept as p dt / (rho cell), in m/s, and the next
// solution begins with it.
#pragma once

#include "liquid/flow/walls.hpp"
#include "liquid/pressure/conjugate_gradients.hpp"

#include <utility>

namespace pastoso::liquid {

/// The matrix of a vessel without free surface: open shares, no boundary.
CellMatrix pressure_matrix(const Walls& walls);

class Projection {
  public:
    explicit Projection(const Walls& walls, const Kernels& kernels = core::kernels<Kernels>());

    /// Makes the velocity on the open faces free of divergence to the tolerance, sets it to 0 on shut
    /// faces between open ones, and continues it into the walls.
    SolveResult project(const Walls& walls, VelocityField& velocity, const SolveLimits& limits,
                        core::ThreadPool& pool);

    const grid::BoxField& pressure() const { return pressure_; }
    /// The next solution begins with it.
    void set_pressure(grid::BoxField pressure) { pressure_ = std::move(pressure); }
    /// Forgets the last solution.
    void start_cold();

  private:
    const Kernels* kernels_;
    ConjugateGradients solver_;
    grid::BoxField pressure_, source_;
};

/// The largest divergence of a cell, |sum of w u| / cell, in 1/s.
float largest_divergence(const Walls& walls, const VelocityField& velocity, core::ThreadPool& pool);

}  // namespace pastoso::liquid
