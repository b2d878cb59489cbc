// The surface around particles, as a signed distance, and how densely they lie.
//
// Near the surface the distance is that of Zhu and Bridson (SIGGRAPH 2005),
//     phi(x) = |x - m| - r,   m = sum w x_p / sum w,   w = (1 - |x - x_p|^2 / R^2)^3,
// or, where that is less, the distance to the nearest particle less r. With r = 0.246 R a half-space
// evenly full of particles has its surface where it ends.
#pragma once

#include "core/thread_pool.hpp"
#include "tank/domain.hpp"
#include "tank/particle_cells.hpp"
#include "tank/particle_kernels.hpp"

namespace pastoso::tank {

/// R of the surface that the pressure sees, and r, in cells.
inline constexpr float kKernelReach_cells = 1.5F;
inline constexpr float particle_radius_cells(float reach_cells) {
    return 0.246F * reach_cells;
}
inline constexpr float kParticleRadius_cells = particle_radius_cells(kKernelReach_cells);

/// The distance phi in cells from the surface around sorted particles, at a point in cells within the
/// box, with that R (0 to 2); R - r where no particle is nearer than R. The box' walls are mirrors, so
/// that the surface meets them at a right angle.
float particle_distance_cells(const ParticleCells& cells, const grid::BoxShape& shape,
                              const glm::vec3& at_cells, float reach_cells,
                              const ParticleKernels& kernels = core::kernels<ParticleKernels>());

class ParticleSurface {
  public:
    explicit ParticleSurface(const Domain& domain);

    /// Signed distances in metres at the middles of all cells within `rows` (at least the particles'
    /// cells widened by one): -r in cells that particles or solids surround on all sides;
    /// within solids what a mirror there would show. R - r in all
    /// others that an earlier call has written. Particles must be sorted.
    void compute(const ParticleCells& cells, const liquid::RowRanges& rows, grid::BoxField& level_m,
                 core::ThreadPool& pool);

    /// After compute(): by how much more volume the particles in and around a cell stand for than there
    /// is liquid, as a share of a cell, within `rows`; cells at the surface are full as far as their
    /// level says. In cells that are not surrounded no less than 0: spray may be thin.
    void compute_excess(const ParticleCells& cells, const liquid::RowRanges& rows,
                        const grid::BoxField& level_m, grid::BoxField& excess, core::ThreadPool& pool);

  private:
    float distance_cells(const ParticleCells& cells, int i, int j, int k) const;
    float blurred(const float* at) const;
    void forget_last(grid::BoxField& level_m, core::ThreadPool& pool);
    void compute_surrounded(const ParticleCells& cells, const liquid::RowRanges& rows,
                            core::ThreadPool& pool);

    grid::BoxShape shape_;
    const Domain* domain_;
    liquid::RowRanges last_rows_;
    std::vector<unsigned char> filled_;      ///< has particles, or is a solid or beyond the box
    std::vector<unsigned char> surrounded_;  ///< all 27 around are filled
    grid::BoxField counts_, full_;           ///< of particles, and how many should be there
};

}  // namespace pastoso::tank
