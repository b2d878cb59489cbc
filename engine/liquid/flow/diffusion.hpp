// Viscosity of a velocity and diffusion of cell values in a walled vessel,
//     dq/dt = kappa laplace q.
// Cell values pass through the open share of faces and their sum is conserved; the components of a
// velocity meet the walls as WallFriction says. Short steps are explicit sub-steps of the 7-point
// formula, longer ones the stages of a Legendre polynomial (RKL1: Meyer, Balsara and Aslam, MNRAS 2012),
// which keeps all values between the least and the largest there were, and the longest implicit
// (backward Euler), by the pressure's multigrid. All are of first order in time.
#pragma once

#include "liquid/flow/region.hpp"
#include "liquid/pressure/conjugate_gradients.hpp"

#include <memory>

namespace pastoso::liquid {

enum class WallFriction {
    Slips,   ///< nothing rubs: no gradient at the wall
    Sticks,  ///< the fluid rests at the wall
};

/// The longest explicit sub-step, as kappa dt / cell^2 (1/6 is the limit of stability), and how many are
/// taken before stages are cheaper. s stages go as far as (s^2 + s) / 2 sub-steps; with more than so
/// many the implicit solution is cheaper.
inline constexpr float kLongestExplicitStep = 0.15F;
inline constexpr int kMaxExplicitSteps = 4, kMaxStages = 7;

class Diffusion {
  public:
    /// Of the samples of a location in regions of one shape; friction matters to faces alone.
    Diffusion(const Region& region, Location location, WallFriction friction,
              const Kernels& kernels = core::kernels<Kernels>());

    /// Must be called where another region than the last one follows.
    void region_changed() { solver_step_ = 0.0F; }

    /// diffusivity_m2_s >= 0 and dt_s >= 0, both finite, else core::InputError.
    SolveResult diffuse(const Region& region, grid::BoxField& field, float diffusivity_m2_s, float dt_s,
                        const SolveLimits& limits, core::ThreadPool& pool);

    /// (1 + `step` times minus the Laplacian), the implicit step's matrix.
    CellMatrix implicit_matrix(const Region& region, float step) const;

  private:
    void legendre_step(const Region& region, grid::BoxField& field, float step, int stages,
                       core::ThreadPool& pool);
    void apply(const Region& region, const Stage& stage, const grid::BoxField& from, grid::BoxField& to,
               core::ThreadPool& pool) const;
    void copy_back(const Region& region, grid::BoxField& field, core::ThreadPool& pool) const;
    SolveResult implicit_step(const Region& region, grid::BoxField& field, float step,
                              const SolveLimits& limits, core::ThreadPool& pool);
    /// How much passes between a sample of the location and the one before it along an axis.
    float passage(const Region& region, int axis, std::ptrdiff_t index) const;
    float wall_passages(const Region& region, std::ptrdiff_t index) const;

    Location location_;
    WallFriction friction_;
    const Kernels* kernels_;
    grid::BoxField next_;
    std::unique_ptr<ConjugateGradients> solver_;  ///< for `solver_step_`
    float solver_step_ = 0.0F;
};

}  // namespace pastoso::liquid
