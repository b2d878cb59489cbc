// A tank at one moment: all that is needed to go on from it, to the last bit.
#pragma once

#include "grid/box_field.hpp"
#include "liquid/flow/velocity.hpp"
#include "tank/particle.hpp"

#include <cstdint>
#include <optional>
#include <vector>

#include <glm/vec3.hpp>

namespace pastoso::tank {

/// Of SurfaceParticles.
struct SurfaceParticleState {
    std::uint32_t seedings = 0;
    std::vector<glm::vec3> positions_m;
    std::vector<float> signed_radii_m;
    friend bool operator==(const SurfaceParticleState&, const SurfaceParticleState&) = default;
};

/// What a level set has besides velocity and pressure.
struct LevelState {
    grid::BoxField level_m, milk;
    double due_m3 = 0.0;
    int steps = 0;
    std::optional<SurfaceParticleState> particles;  ///< of Method::ParticleLevelSet
    friend bool operator==(const LevelState&, const LevelState&) = default;
};

/// Of a LiquidMethod.
struct LiquidState {
    liquid::VelocityField velocity;
    grid::BoxField pressure;  ///< where the next solution begins
    float fastest_m_s = 0.0F;
    std::vector<Particle> particles;  ///< of Method::Particles, in their order
    std::uint32_t particles_made = 0;
    std::optional<LevelState> level;  ///< of all others
    friend bool operator==(const LiquidState&, const LiquidState&) = default;
};

struct TankState {
    double time_s = 0.0;
    int steps = 0;
    double brought_m3 = 0.0;
    LiquidState liquid;
    friend bool operator==(const TankState&, const TankState&) = default;
};

}  // namespace pastoso::tank
