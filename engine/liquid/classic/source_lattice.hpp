// The fluid of "Rendering Milk Tea" (2010), as it was: Stable Fluids (J. Stam, SIGGRAPH 1999) on a small
// periodic lattice whose points hold whole velocities. A step of time dt:
//     w1 = u + dt f                          whoever uses it adds the force
//     w2(x) = w1(b(x, -dt))                  carried back along w1 by the midpoint rule
//     (1 - nu dt laplace) w3 = w2            viscosity
//     laplace q = div w3,  u = w3 - grad q   pressure
// with the seven-point Laplacian and central differences. There the two linear systems are solved by
// singular values; on a periodic lattice their solutions of least norm are found by Fourier transforms.
//
// Central differences leave divergence, and between the points there is more: particles pile up.
// periodic.hpp is what the product uses.
#pragma once

#include "core/thread_pool.hpp"
#include "grid/box_field.hpp"
#include "liquid/classic/fourier.hpp"

#include <array>

#include <glm/vec3.hpp>

namespace pastoso::liquid {

class SourceLattice {
  public:
    /// At rest; as many points along each side of a cube, at the cells' middles.
    explicit SourceLattice(const grid::BoxShape& shape);

    /// Along an axis in m/s; forces are added to it.
    grid::BoxField& along(int axis) { return u_[static_cast<std::size_t>(axis)]; }
    const grid::BoxField& along(int axis) const { return u_[static_cast<std::size_t>(axis)]; }

    /// All but the force.
    void step(float dt_s, float viscosity_m2_s, core::ThreadPool& pool);

    /// By cubic interpolation (Catmull-Rom); points beyond the box are those on its other side.
    glm::vec3 velocity_at(const glm::vec3& point_m) const;

  private:
    void carry_velocity(float dt_s, core::ThreadPool& pool);
    void diffuse_and_project(float spread_m2, core::ThreadPool& pool);
    void project_row(int j, int k, float spread_m2);
    void fill_ghosts(core::ThreadPool& pool);

    std::array<grid::BoxField, 3> u_, carried_;
    std::array<FourierBox, 3> spectra_;
};

/// The same place in a periodic cube with a corner at the origin.
glm::vec3 wrapped(const glm::vec3& point_m, float box_m);

}  // namespace pastoso::liquid
