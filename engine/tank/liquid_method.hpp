// How the liquid of a tank is followed: what particles and level sets have in common.
#pragma once

#include "core/thread_pool.hpp"
#include "liquid/pressure/conjugate_gradients.hpp"
#include "tank/seeding.hpp"
#include "tank/tank_frame.hpp"
#include "tank/tank_scene.hpp"
#include "tank/tank_state.hpp"

#include <span>

namespace pastoso::tank {

/// Where a jet comes from.
struct Nozzle {
    liquid::SignedDistance form_m;
    CellSet cells;       ///< upstream first
    int full_count = 0;  ///< of particles
};
Nozzle nozzle_of(const Jet& jet, const Domain& domain);

/// How exactly a scene wants its pressure solved.
liquid::SolveLimits pressure_limits(const TankScene& scene);

/// Throws InputError unless all fields have that shape.
void check_shapes(std::span<const grid::BoxField* const> fields, const grid::BoxShape& shape);

class LiquidMethod {
  public:
    virtual ~LiquidMethod() = default;

    /// Liquid appears where there is none yet.
    virtual void add(const LiquidBody& body) = 0;
    /// What is in the cells is gone.
    virtual void drain(const CellSet& cells) = 0;
    /// What is in the nozzle moves as the jet does; what left it is made up for.
    virtual void run_jet(const Jet& jet, const Nozzle& nozzle) = 0;
    /// Brings surface and volume up to date after those three. To be called before a step.
    virtual void apply_changes(core::ThreadPool& pool) = 0;

    /// One step of dt_s (> 0), after which nothing shall move by more than a cell; the scene's numbers
    /// and its wind, if that blows now.
    virtual liquid::SolveResult step(const TankScene& scene, const Wind* wind, float dt_s,
                                     core::ThreadPool& pool) = 0;

    /// The largest component of the velocity, in m/s.
    virtual float fastest_m_s() const = 0;
    virtual double volume_m3(core::ThreadPool& pool) const = 0;
    /// On faces beside the liquid and two cells further.
    virtual const liquid::VelocityField& velocity() const = 0;
    /// Level and milk of a frame whose fields have their shapes already.
    virtual void show(TankFrame& frame, core::ThreadPool& pool) const = 0;
    virtual std::span<const Particle> particles() const { return {}; }

    /// Between two steps.
    virtual LiquidState state() const = 0;
    /// Throws InputError when it is not a state of this method in this domain.
    virtual void set_state(LiquidState state, core::ThreadPool& pool) = 0;
};

}  // namespace pastoso::tank
