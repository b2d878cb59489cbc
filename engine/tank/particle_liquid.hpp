// Liquid that is carried by particles (FLIP). One step of time dt:
//     particles to faces; the surface around them; u += dt (gravity + wind + confinement), viscosity;
//     walls; make u free of divergence, mending the density; continue u into the air; walls;
//     faces to particles, which move.
#pragma once

#include "tank/forces.hpp"
#include "tank/free_surface.hpp"
#include "tank/liquid_method.hpp"
#include "tank/particle_surface.hpp"
#include "tank/transfer.hpp"
#include "tank/velocity_rings.hpp"

#include <vector>

namespace pastoso::tank {

class ParticleLiquid final : public LiquidMethod {
  public:
    ParticleLiquid(const Domain& domain, std::uint32_t seed);

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
    std::span<const Particle> particles() const override { return particles_; }

    LiquidState state() const override;
    void set_state(LiquidState state, core::ThreadPool& pool) override;

  private:
    const grid::BoxShape& shape() const { return domain_->shape(); }
    void copy_velocity(core::ThreadPool& pool);
    void compute_growth(const liquid::RowRanges& near, double volume_rate, float dt_s,
                        core::ThreadPool& pool);
    void compute_known(core::ThreadPool& pool);
    void keep_out_of_solids(core::ThreadPool& pool);

    const Domain* domain_;
    std::uint32_t seed_, made_ = 0;  ///< of the particles' places, and how many were made
    std::vector<Particle> particles_;
    bool in_order_ = true;
    ParticleCells cells_;
    Transfer transfer_;
    ParticleSurface particle_surface_;
    FreeSurface surface_;
    VelocityRings rings_;
    InnerForces inner_forces_;
    liquid::VelocityField velocity_, old_velocity_, known_;
    grid::BoxField growth_;
    liquid::RowRanges samples_;  ///< where a step knows the velocity
    float fastest_m_s_ = 0.0F;   ///< along an axis
};

}  // namespace pastoso::tank
