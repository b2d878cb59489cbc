// What moves the liquid of a tank but its pressure.
#pragma once

#include "liquid/flow/diffusion.hpp"
#include "tank/free_surface.hpp"
#include "tank/tank_scene.hpp"

#include <memory>

namespace pastoso::tank {

/// Gravity on all faces within `samples`, and the wind where the level is less deep than deep_m (> 0).
void add_gravity_and_wind(const TankScene& scene, const Wind* wind, float dt_s,
                          const grid::BoxField& level_m, float deep_m, const liquid::RowRanges& samples,
                          liquid::VelocityField& velocity, core::ThreadPool& pool);

/// Viscosity and the confinement of vorticity: within the liquid, and as if nothing rubbed at its
/// surface and walls.
class InnerForces {
  public:
    void add(const TankScene& scene, const FreeSurface& surface, float dt_s,
             liquid::VelocityField& velocity, core::ThreadPool& pool);

  private:
    std::array<std::unique_ptr<liquid::Diffusion>, 3> diffusions_;  ///< made when first needed
};

}  // namespace pastoso::tank
