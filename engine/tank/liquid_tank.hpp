// Liquid with a free surface in a glass tank, as its scene says: bodies of liquid, solids, jets, drains
// and wind.
#pragma once

#include "tank/liquid_method.hpp"

#include <functional>
#include <memory>
#include <vector>

namespace pastoso::tank {

struct TankStep {
    double dt_s = 0.0;
    liquid::SolveResult pressure;
};

class LiquidTank {
  public:
    /// Throws InputError like check_tank().
    explicit LiquidTank(const TankScene& scene);

    const TankScene& scene() const { return scene_; }
    const grid::BoxShape& shape() const { return domain_->shape(); }
    const Domain& domain() const { return *domain_; }
    /// The same for who needs it longer than the tank.
    std::shared_ptr<const Domain> shared_domain() const { return domain_; }

    /// One step as long as the Courant number allows, but no longer than `most_s` (> 0).
    TankStep step(double most_s, core::ThreadPool& pool);
    /// Steps until `time_s`; returns how many. Each is told, where there is someone to tell.
    int advance_to(double time_s, core::ThreadPool& pool,
                   const std::function<void(const TankStep&)>& tell = {});

    double time_s() const { return time_s_; }
    int steps() const { return steps_; }
    /// Of Method::Particles; of others none.
    std::span<const Particle> particles() const { return method_->particles(); }
    const liquid::VelocityField& velocity() const { return method_->velocity(); }
    double volume_m3(core::ThreadPool& pool) const { return method_->volume_m3(pool); }

    /// What bodies added later and jets brought less what drains took, in volume_m3().
    double brought_m3() const { return brought_m3_; }
    /// The largest component of the velocity, in m/s.
    float fastest_m_s() const { return method_->fastest_m_s(); }

    /// What follows a state is the same to the last bit, in any tank of the scene. What set_wind() and
    /// open_drains() changed is not in it.
    TankState state() const { return {time_s_, steps_, brought_m3_, method_->state()}; }
    /// Throws InputError when it is that of another tank.
    void set_state(TankState state, core::ThreadPool& pool);

    /// What it looks like, with `parts` samples (1 to 4) along a cell: the same on any number of
    /// threads.
    TankFrame frame(int parts, core::ThreadPool& pool) const;

    /// Liquid of that form appears where there is none yet.
    void add(const LiquidBody& body, core::ThreadPool& pool);
    /// Changes that hold from the next step on.
    void set_wind(const Wind& wind);
    /// All of tank_numbers() but the cell's side.
    void set_numbers(const TankScene& numbers);
    void open_drains(bool open) { drains_open_ = open; }

  private:
    bool is_fed_or_drained() const;
    void drain();
    void run_jets();
    double longest_step_s() const;

    TankScene scene_;
    std::shared_ptr<const Domain> domain_;  ///< stays in its place when the tank moves
    std::unique_ptr<LiquidMethod> method_;
    std::vector<CellSet> drains_;
    std::vector<Nozzle> nozzles_;  ///< of the scene's jets
    bool drains_open_ = true;
    double time_s_ = 0.0;
    int steps_ = 0;
    double brought_m3_ = 0.0;
};

}  // namespace pastoso::tank
