// Particles on both sides of a level set's surface, which mend it where it loses corners and thin
// sheets: the particle level set (Enright, Fedkiw, Ferziger and Mitchell, J. Comput. Phys. 183, 2002).
// Each is a ball that touches the surface from its own side. One that is found on the other side by more
// than its radius has escaped: there the surface is wrong, and the balls of the escaped ones are put
// back.
#pragma once

#include "core/thread_pool.hpp"
#include "grid/box_field.hpp"
#include "liquid/flow/advection.hpp"
#include "tank/tank_state.hpp"

#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include <glm/vec3.hpp>

namespace pastoso::tank {

struct SurfaceParticleSettings {
    int per_cell = 32;        ///< 1 to 64
    float band_cells = 3.0F;  ///< they keep within this distance of the surface
    float least_radius_cells = 0.1F, most_radius_cells = 0.5F;
    std::uint32_t seed = 1;
    liquid::Interpolation interpolation = liquid::Interpolation::Linear;  ///< of the velocity
};

class SurfaceParticles {
  public:
    explicit SurfaceParticles(const grid::BoxShape& shape, const SurfaceParticleSettings& settings = {});

    /// Anew around the surface of phi.
    void seed(const grid::BoxField& phi, core::ThreadPool& pool);

    /// Along a velocity on faces that is known as far as they go; see liquid::carry_points.
    void carry(const liquid::VelocityField& velocity, float dt_s, core::ThreadPool& pool);

    /// Where particles have escaped, phi at the eight middles around each becomes
    ///     s (r - |x - x_p|),  s = 1 in the air, -1 in the liquid,
    /// if that is farther on its side than phi is; of both sides' claims the one closer to 0 holds.
    /// Returns how many have escaped.
    std::size_t mend(grid::BoxField& phi, core::ThreadPool& pool);

    /// Balls touch the surface of phi again, as far as the range of radii allows; escaped ones become as
    /// small as can be.
    void adjust_radii(const grid::BoxField& phi, core::ThreadPool& pool);

    /// Particles that have strayed from the band go, and so do those beyond one and a half times
    /// per_cell in a cell; cells of the band that have too few are filled up. Escaped ones stay, and
    /// nothing is added beside them: there phi is not to be trusted.
    void reseed(const grid::BoxField& phi, core::ThreadPool& pool);

    /// Forgets those in a place, as when a drain or a body put into the liquid changes phi there.
    void remove_where(const std::function<bool(const glm::vec3& position_m)>& gone);

    SurfaceParticleState state() const { return {generation_, positions_m_, signed_radii_m_}; }
    /// Throws InputError when a particle is not within the box.
    void set_state(SurfaceParticleState state);

    std::span<const glm::vec3> positions_m() const { return positions_m_; }
    /// Positive in the air, negative in the liquid.
    std::span<const float> signed_radii_m() const { return signed_radii_m_; }

  private:
    struct Particle {
        glm::vec3 position_m;
        float signed_radius_m;
    };
    float signed_radius_m(float phi_m, bool in_air) const;
    void fill_up(const grid::BoxField& phi, int i, int j, int k, int count,
                 std::vector<Particle>& particles) const;
    void reseed_slice(const grid::BoxField& phi, int k, std::vector<Particle>& particles) const;
    void sort_into_cells();
    void claim(const grid::BoxField& phi, std::uint32_t particle);

    /// What escaped particles claim of a sample.
    struct Claim {
        std::uint32_t index;
        float air_m, liquid_m;
    };

    grid::BoxShape shape_;
    SurfaceParticleSettings settings_;
    std::uint32_t generation_ = 0;  ///< counts the seedings
    std::vector<glm::vec3> positions_m_;
    std::vector<float> signed_radii_m_;
    std::vector<std::uint32_t> order_, cell_begin_;  ///< particles by cell, while they are reseeded
    std::vector<std::int32_t> slots_;  ///< of each sample, where its claim stands; -1: none
    std::vector<Claim> claims_;
};

}  // namespace pastoso::tank
