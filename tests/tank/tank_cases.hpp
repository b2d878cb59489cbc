// Scenes and shapes that the tests of the tank have in common.
#pragma once

#include "core/random.hpp"
#include "tank/liquid_tank.hpp"

#include <vector>

namespace pastoso::tank::cases {

inline Shape block(const glm::vec3& low_m, const glm::vec3& high_m) {
    return {Block{low_m, high_m}};
}

/// A cube of that many cells, a metre wide, a block of it full of clear liquid.
inline TankScene dam(int cells, const glm::vec3& high_m) {
    TankScene scene;
    scene.cells = glm::ivec3(cells);
    scene.cell_m = 1.0 / cells;
    scene.liquids.push_back({block(glm::vec3(0.0F), high_m), glm::vec3(0.0F), 0.0F});
    return scene;
}

/// Particles anywhere in a box, with velocities of up to 1 m/s along each axis.
inline std::vector<Particle> random_particles(const grid::BoxShape& shape, int count,
                                              std::uint32_t seed) {
    std::vector<Particle> particles(static_cast<std::size_t>(count));
    std::uint32_t n = 0;
    const auto number = [&] { return core::uniform_noise(n++, seed); };
    const glm::vec3 size_m = glm::vec3(shape.nx, shape.ny, shape.nz) * shape.cell_m;
    for (Particle& particle : particles) {
        for (const int axis : liquid::kAxes) {
            particle.position_m[axis] = size_m[axis] * number();
            particle.velocity_m_s[axis] = 2.0F * number() - 1.0F;
        }
        particle.milk = number();
    }
    return particles;
}

}  // namespace pastoso::tank::cases
