// A tank of liquid at one moment: all that is needed to draw it.
#pragma once

#include "liquid/surface/sampled_field.hpp"
#include "tank/domain.hpp"
#include "tank/particle_surface.hpp"

#include <span>

namespace pastoso::tank {

struct TankFrame {
    double time_s = 0.0;
    int step = 0;
    /// Signed distance from the surface, negative in the liquid, at the points of frame_lattice(). It
    /// goes on for a cell into walls and solids.
    liquid::SampledField level_m;
    grid::BoxField milk;  ///< share of milk in cells that have liquid or lie beside it
};

/// `parts` (1 to 4) points along the side of a cell, and a cell more on every side of the box.
liquid::Lattice frame_lattice(const grid::BoxShape& shape, int parts);

/// The frame's level around sorted particles: particle_distance_cells() with R = kFrameReach_cells, made
/// even over the particles' bumps, but so that drops and thin sheets stay.
void sample_particles(const ParticleCells& cells, const Domain& domain, liquid::SampledField& level_m,
                      core::ThreadPool& pool);
inline constexpr float kFrameReach_cells = 1.5F;

/// The frame's level from a signed distance at cells' middles, by cubic interpolation.
void sample_level(const grid::BoxField& cells_m, const Domain& domain, liquid::SampledField& level_m,
                  core::ThreadPool& pool);

/// The mean milk of the particles in each cell, and beside them that of the cells next to it.
void average_milk(std::span<const Particle> particles, const ParticleCells& cells, grid::BoxField& milk,
                  core::ThreadPool& pool);

}  // namespace pastoso::tank
