// A drop of liquid that is followed through the tank.
#pragma once

#include <glm/vec3.hpp>

namespace pastoso::tank {

struct Particle {
    glm::vec3 position_m{0.0F};
    float milk = 0.0F;  ///< share of milk in it, 0 to 1
    glm::vec3 velocity_m_s{0.0F};
    friend bool operator==(const Particle&, const Particle&) = default;
};

/// A cell is full with so many: two along each axis.
inline constexpr int kParticlesPerCell = 8;

}  // namespace pastoso::tank
