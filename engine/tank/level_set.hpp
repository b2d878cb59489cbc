// The surface of a liquid as the zero of phi: the signed distance at cells' middles, in metres, negative
// in the liquid, known within `reach` of the surface and plus or minus that reach beyond it.
//
// A step of the method goes:
//   1. VelocityExtension continues the velocity, free of divergence in the liquid, into the air
//      (extension.hpp);
//   2. LevelSetAdvection carries phi along it, by at most a cell;
//   3. SurfaceParticles, where there are any, are carried along the same velocity and mend phi
//      (particle_level_set.hpp);
//   4. every kStepsPerReinitialisation steps Reinitialisation makes phi a distance again
//      (reinitialisation.hpp): kept_within_cells is kKeptWithin_cells without particles, 0 with them,
//      and their radii are adjusted to it;
//   5. every kStepsPerReseeding steps the particles are reseeded.
// Liquid comes and goes (jets, drains, bodies put in) by min and max with another distance; then phi is
// made a distance again, and the particles of that place are removed and reseeded, for they would undo
// the change. Everything that changes phi here leaves the two samples around the box up to date; who
// changes phi otherwise calls continue_beyond_walls().
#pragma once

#include "liquid/flow/advection.hpp"

namespace pastoso::tank {

inline constexpr float kLevelSetReach_cells = 5.0F;
inline constexpr int kStepsPerReinitialisation = 5;
inline constexpr float kKeptWithin_cells = 0.1F;  ///< without particles; with them 0
inline constexpr int kStepsPerReseeding = 20;

/// Continues values at cells' middles in straight lines into the two samples beyond each wall: the
/// surface goes on into the wall as it meets it.
void continue_beyond_walls(grid::BoxField& phi);

/// For each row what lies between its first and its last cell with |phi| < reach.
liquid::RowRanges band_rows(const grid::BoxField& phi, float reach_cells, core::ThreadPool& pool);

enum class LevelSetScheme {
    Upwind,          ///< first order: one-sided differences on the side that the flow comes from, Euler
    SemiLagrangian,  ///< back along the flow, see liquid/advection.hpp
};

class LevelSetAdvection {
  public:
    explicit LevelSetAdvection(const grid::BoxShape& shape,
                               const liquid::Kernels& kernels = core::kernels<liquid::Kernels>());

    /// Solves d phi/dt + u . grad phi = 0 over dt_s in the band. Upwind takes as many equal
    /// parts of the step as keep |u| + |v| + |w| within a cell a part; the way of a whole step should be
    /// at most a cell.
    void advect(grid::BoxField& phi, const liquid::VelocityField& velocity, float dt_s,
                float reach_cells, LevelSetScheme scheme, core::ThreadPool& pool,
                liquid::Interpolation interpolation = liquid::Interpolation::Cubic);

  private:
    /// Between the parts of the band there may be cells in its rows whose velocity is not known.
    void restore_beyond(float reach_cells, const liquid::RowRanges& rows, grid::BoxField& phi,
                        core::ThreadPool& pool) const;
    void advect_upwind(grid::BoxField& phi, const liquid::VelocityField& velocity, float dt_s,
                       float reach_cells, const liquid::RowRanges& rows, core::ThreadPool& pool);

    liquid::Advection advection_;
    grid::BoxField before_;
};

}  // namespace pastoso::tank
