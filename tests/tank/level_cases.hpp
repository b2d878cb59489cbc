// Surfaces and flows that the tests and benchmarks of the level set share.
#pragma once

#include "tank/level_set.hpp"
#include "tank/particle_level_set.hpp"
#include "tank/reinitialisation.hpp"

#include <functional>

#include <glm/vec3.hpp>

namespace pastoso::tank::cases {

/// A cube of one metre.
grid::BoxShape unit_box(int cells);

using Distance = std::function<float(const glm::vec3& point_m)>;
/// A field at cells' middles, two samples beyond the box among them.
grid::BoxField sampled(const grid::BoxShape& shape, const Distance& value);

Distance sphere(const glm::vec3& centre_m, float radius_m);

enum class Flow {
    Rotation,  ///< one turn of a sphere of radius 0.15 at (0.35, 0.35, 0.35) about the upright middle
    Enright,   ///< a sphere of that size and place is pulled to a thin sheet and back in 3 seconds
    Tank,      ///< the same flow for a second, in the lower 0.4 m of the box; the air's velocity is
               ///< not known, but continued from the liquid's
};
/// With the samples around the box.
liquid::VelocityField velocity_at_start(Flow flow, const grid::BoxShape& shape);

struct Following {
    LevelSetScheme scheme = LevelSetScheme::SemiLagrangian;
    liquid::Interpolation interpolation = liquid::Interpolation::Cubic;
    float reach_cells = kLevelSetReach_cells;
    int steps_per_reinitialisation =
        kStepsPerReinitialisation;  ///< 0: never, and phi is kept everywhere
    float kept_within_cells = 0.0F;
    int particles_per_cell = 0;                    ///< 0: none
    int steps_per_reseeding = kStepsPerReseeding;  ///< 0: never
    double courant = 0.9;
};
struct Followed {
    grid::BoxField phi;
    double volume_error = 0.0;  ///< relative, at the end
    double shape_error = 0.0;   ///< volume between the surfaces before and after over the sphere's
    std::size_t particles = 0, escaped = 0;  ///< at the end
    int steps = 0;
    double seconds = 0.0;  ///< processor time of the steps, without the velocity's
};
Followed follow(Flow flow, int cells, const Following& how, core::ThreadPool& pool);

}  // namespace pastoso::tank::cases
