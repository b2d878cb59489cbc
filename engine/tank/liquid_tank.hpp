// Liquid with a free surface in a glass tank. One step of time dt by particles:
//     drains and jets; particles to faces; the surface around them;
//     u += dt (gravity + wind + confinement), viscosity; walls; make u free of divergence, mending the
//     density; continue u into the air; walls; faces to particles, which move.
#pragma once

#include "liquid/diffusion.hpp"
#include "tank/free_surface.hpp"
#include "tank/particle_surface.hpp"
#include "tank/seeding.hpp"
#include "tank/tank_frame.hpp"
#include "tank/tank_scene.hpp"
#include "tank/transfer.hpp"
#include "tank/velocity_rings.hpp"

#include <memory>
#include <vector>

namespace pastoso::tank {

struct TankStep {
    double dt_s = 0.0;
    liquid::SolveResult pressure;
};

class LiquidTank {
  public:
    /// Throws InputError like check_tank(), and where there is no room for liquid at all.
    explicit LiquidTank(const TankScene& scene);

    const TankScene& scene() const { return scene_; }
    const grid::BoxShape& shape() const { return room_.shape(); }

    /// One step as long as the Courant number allows, but no longer than `most_s` (> 0).
    TankStep step(double most_s, core::ThreadPool& pool);
    /// Steps until `time_s`; returns how many.
    int advance_to(double time_s, core::ThreadPool& pool);

    double time_s() const { return time_s_; }
    int steps() const { return steps_; }
    const std::vector<Particle>& particles() const { return particles_; }
    const liquid::VelocityField& velocity() const { return velocity_; }
    const FreeSurface& surface() const { return surface_; }
    const Room& room() const { return room_; }
    /// What the particles stand for.
    double volume_m3() const {
        return static_cast<double>(particles_.size()) * shape().cell_volume_m3() / kParticlesPerCell;
    }

    /// What it looks like: the same on any number of threads.
    TankFrame frame(int parts, core::ThreadPool& pool) const;

    /// Liquid of that form appears where there is none yet.
    void add(const LiquidBody& body);
    /// Changes that hold from the next step on.
    void set_wind(const Wind& wind);
    void open_drains(bool open) { drains_open_ = open; }

  private:
    struct Nozzle {
        liquid::SignedDistance form_m;
        CellSet cells;  ///< upstream first
        int full_count;
    };

    void add(const LiquidBody& body, Octants& octants);
    bool drain();
    bool run_jets();
    void run_jet(const Jet& jet, const Nozzle& nozzle, Octants& octants);
    double longest_step_s() const;
    void copy_velocity(core::ThreadPool& pool);
    void add_forces(float dt_s, core::ThreadPool& pool);
    void add_inner_forces(float dt_s, core::ThreadPool& pool);
    void find_growth(const liquid::RowRanges& near, float dt_s, core::ThreadPool& pool);
    void find_known(core::ThreadPool& pool);
    void take_stock(core::ThreadPool& pool);
    void keep_out_of_solids(core::ThreadPool& pool);

    TankScene scene_;
    Room room_;
    std::vector<Particle> particles_;
    ParticleCells cells_;
    Transfer transfer_;
    ParticleSurface particle_surface_;
    FreeSurface surface_;
    VelocityRings rings_;
    liquid::VelocityField velocity_, old_velocity_, known_;
    grid::BoxField growth_;
    liquid::RowRanges samples_;                                     ///< where a step knows the velocity
    std::array<std::unique_ptr<liquid::Diffusion>, 3> diffusions_;  ///< of viscous liquids
    std::vector<CellSet> drains_;
    std::vector<Nozzle> nozzles_;  ///< of the scene's jets
    std::uint32_t particles_made_ = 0;
    float fastest_m_s_ = 0.0F;  ///< along an axis
    bool drains_open_ = true;
    double time_s_ = 0.0;
    int steps_ = 0;
};

}  // namespace pastoso::tank
