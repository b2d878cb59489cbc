// Liquid whose surface is the zero of a signed distance phi that is carried along the velocity: the way
// of "Realistisk simulering och visualisering av fluider" (2009), and the same with particles that mend
// the surface, which that work wished for. One step of time dt:
//     u += dt (gravity + wind + confinement), viscosity; walls; make u free of divergence but for the
//     volume that was lost; continue u along the normals into the air; walls;
//     carry phi, the particles and the milk along u; carry u along u.
#pragma once

#include "tank/extension.hpp"
#include "tank/forces.hpp"
#include "tank/level_set.hpp"
#include "tank/liquid_method.hpp"
#include "tank/particle_level_set.hpp"
#include "tank/reinitialisation.hpp"

#include <optional>

namespace pastoso::tank {

class LevelSetLiquid final : public LiquidMethod {
  public:
    /// Any method but Method::Particles.
    LevelSetLiquid(const Domain& domain, Method method, std::uint32_t seed);

    void add(const LiquidBody& body) override;
    void drain(const CellSet& cells) override;
    void run_jet(const Jet& jet, const Nozzle& nozzle) override;
    void apply_changes(core::ThreadPool& pool) override;
    liquid::SolveResult step(const TankScene& scene, const Wind* wind, float dt_s,
                             core::ThreadPool& pool) override;

    float fastest_m_s() const override { return fastest_m_s_; }
    double volume_m3(core::ThreadPool& pool) const override;
    const liquid::VelocityField& velocity() const override { return velocity_; }
    void show(TankFrame& frame, core::ThreadPool& pool) const override;

    LiquidState state() const override;
    void set_state(LiquidState state, core::ThreadPool& pool) override;

  private:
    const grid::BoxShape& shape() const { return domain_->shape(); }
    grid::BoxField& level_m() { return surface_.level_m(); }
    void put(const liquid::SignedDistance& form_m, const glm::vec3& velocity_m_s, float milk);
    void set_velocity(const glm::ivec3& cell, const glm::vec3& velocity_m_s);
    float kept_within_cells() const { return particles_ ? 0.0F : kKeptWithin_cells; }
    void compute_rows(core::ThreadPool& pool);
    void compute_growth(const TankScene& scene, float dt_s);
    void compute_known(core::ThreadPool& pool);
    void carry_surface(float dt_s, core::ThreadPool& pool);
    void carry_velocity_and_milk(float dt_s, core::ThreadPool& pool);
    void carry_milk(float dt_s, core::ThreadPool& pool);
    void compute_fastest(core::ThreadPool& pool);

    const Domain* domain_;
    FreeSurface surface_;
    LevelSetScheme scheme_;
    LevelSetAdvection level_advection_;
    Reinitialisation reinitialisation_;
    std::optional<SurfaceParticles> particles_;
    VelocityExtension extension_;
    InnerForces inner_forces_;
    liquid::Advection advection_;
    liquid::VelocityField velocity_, advected_, known_;
    grid::BoxField milk_, advected_milk_, advected_share_, growth_;
    liquid::RowRanges near_, samples_;         ///< cells and samples that a step works on
    double due_m3_ = 0.0, last_m3_ = 0.0;      ///< the volume that there should be, and what there is
    bool changed_ = false, reshaped_ = false;  ///< since apply_changes(): at all, by more than a jet
    float fastest_m_s_ = 0.0F;
    int steps_ = 0;
};

}  // namespace pastoso::tank
