// What particles and grid tell each other (FLIP: Brackbill and Ruppel 1986; Zhu and Bridson, "Animating
// sand as a fluid", SIGGRAPH 2005).
//
// Values of particles go to the faces around them with trilinear weights:
//     u_f = sum_p w_pf u_p / sum_p w_pf.
// After the grid has made of `old` the velocity `now`, particles take
//     u_p = now(x) + share (u_p - old(x))
// and move along `now` by the midpoint rule.
#pragma once

#include "core/thread_pool.hpp"
#include "liquid/flow/aligned_floats.hpp"
#include "liquid/flow/velocity.hpp"
#include "tank/particle_cells.hpp"
#include "tank/particle_kernels.hpp"

#include <array>

namespace pastoso::tank {

class Transfer {
  public:
    explicit Transfer(const grid::BoxShape& shape,
                      const ParticleKernels& kernels = core::kernels<ParticleKernels>());

    /// Writes the velocity on all faces within `samples` (at least the particles' cells widened by one):
    /// 0 where no particle is near; `weight` is the sum of weights there. Particles must be sorted. The
    /// same bits on any number of threads.
    void to_faces(const std::vector<Particle>& particles, const ParticleCells& cells,
                  const liquid::RowRanges& samples, liquid::VelocityField& velocity,
                  liquid::VelocityField& weight, core::ThreadPool& pool);

    /// Gives the particles their new velocities and moves them; who leaves the box is put back into it.
    /// Both velocities must be known within `samples` (the particles' cells widened by three). Returns
    /// the largest component of a particle's velocity.
    float to_particles(const liquid::VelocityField& old, const liquid::VelocityField& now,
                       const liquid::RowRanges& samples, const Following& how,
                       std::vector<Particle>& particles, core::ThreadPool& pool);

  private:
    void clear(core::ThreadPool& pool);
    void scatter_slices(const std::vector<Particle>& particles, const ParticleCells& cells, int block);

    grid::BoxShape shape_;
    const ParticleKernels* kernels_;
    /// For each axis two numbers a face: momentum and weight, or `now` and what it has more than `old`.
    std::array<liquid::AlignedFloats, 3> pairs_;
    liquid::RowRanges used_;  ///< what rows of them are not 0
};

}  // namespace pastoso::tank
