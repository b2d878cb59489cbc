// One step of an incompressible fluid in a walled vessel, as stages that whoever models something in the
// fluid calls in this order:
//     velocity() += dt times accelerations, on the faces (without the hydrostatic part)
//     diffuse_velocity(dt)     viscosity
//     project()                velocity becomes free of divergence and known in the walls
//     diffuse_cells(), advect_cells(), carry() of whatever moves along, with that velocity
//     advect_velocity(dt)      last
#pragma once

#include "liquid/flow/advection.hpp"
#include "liquid/flow/diffusion.hpp"
#include "liquid/flow/walls.hpp"
#include "liquid/pressure/pressure.hpp"

#include <optional>
#include <vector>

namespace pastoso::liquid {

enum class VelocityAdvection {
    Once,       ///< first order in time
    Reflected,  ///< advection-reflection, second order (Zehnder, Narain and Thomaszewski 2018)
};

struct FlowParameters {
    float viscosity_m2_s = 2e-6F;  ///< 0 and more
    WallFriction friction = WallFriction::Slips;
    float confinement = 0.0F;  ///< vorticity confinement, 0 to 0.3, without unit
    VelocityAdvection velocity_advection = VelocityAdvection::Once;
    Interpolation interpolation = Interpolation::LimitedCubic;
    SolveLimits pressure = {};            ///< 1e-3 live, 1e-5 for an export
    SolveLimits diffusion = {1e-5F, 50};  ///< of long steps of viscosity and diffusion
    friend bool operator==(const FlowParameters& a, const FlowParameters& b) = default;
};
/// Throws core::InputError.
void check(const FlowParameters& parameters);

/// Whether advected cell values are scaled to the sum they had: the clamped cubic alone gains some
/// percent in a long run.
enum class KeepSum { No, Yes };

/// All that a step passes on to the next one. An advection writes into spare fields, and of those the
/// open samples alone: what they hold within the walls is seen after the next step but one, so that it
/// belongs to the state as well.
struct FlowState {
    VelocityField velocity;
    grid::BoxField pressure;
    VelocityField spare_velocity;             ///< open samples are 0
    std::vector<grid::BoxField> spare_cells;  ///< the same; as many as were advected together
    friend bool operator==(const FlowState&, const FlowState&) = default;
};

class VesselFlow {
  public:
    /// The fluid at rest. Throws core::InputError for a bad shape, distance or parameter.
    VesselFlow(const grid::BoxShape& shape, const SignedDistance& distance,
               const FlowParameters& parameters = {}, const Kernels& kernels = core::kernels<Kernels>());

    const grid::BoxShape& shape() const { return walls_.shape(); }
    const Walls& walls() const { return walls_; }
    const FlowParameters& parameters() const { return parameters_; }
    void set_parameters(const FlowParameters& parameters);

    /// Forces may be added to it on the open faces, until another function is called; other faces do not
    /// count.
    VelocityField& velocity() {
        is_followed_ = false;
        return velocity_;
    }
    const VelocityField& velocity() const { return velocity_; }
    const grid::BoxField& pressure() const { return projection_.pressure(); }

    /// What follows a state is the same to the last bit, whoever was in it before.
    FlowState state() const;
    /// Throws core::InputError when its fields have another shape, or are more than kMaxFieldsTogether.
    void set_state(FlowState state);

    /// Vorticity confinement, a force eps h (N x omega): see FlowParameters::confinement.
    void confine_vorticity(float dt_s, core::ThreadPool& pool);
    SolveResult diffuse_velocity(float dt_s, core::ThreadPool& pool);
    SolveResult project(core::ThreadPool& pool);

    /// Up to kMaxFieldsTogether fields, diffusivity in m2/s; see diffusion.hpp.
    SolveResult diffuse_cells(grid::BoxField& field, float diffusivity_m2_s, float dt_s,
                              core::ThreadPool& pool);
    /// Cell fields that share one way back. Continues them into the walls first.
    void advect_cells(std::span<grid::BoxField* const> fields, float dt_s, KeepSum keep,
                      core::ThreadPool& pool);
    /// Moves points along the velocity, by its cubic; the caller pushes them out of walls.
    void carry(std::span<glm::vec3> points_m, float dt_s, core::ThreadPool& pool) const;
    /// The same on this thread alone.
    void carry(std::span<glm::vec3> points_m, float dt_s) const;

    /// Leaves the velocity with divergence: the next step's project() removes it. Returns how well the
    /// projection between went (Reflected).
    SolveResult advect_velocity(float dt_s, core::ThreadPool& pool);

    /// The sum of a field's values over open cells, the same on any number of threads.
    double sum_over_cells(const grid::BoxField& field, core::ThreadPool& pool) const;
    /// Makes that sum another, by a factor; a field that has none of that sign stays as it is.
    void scale_to_sum(grid::BoxField& field, double sum, core::ThreadPool& pool) const;

  private:
    void follow(core::ThreadPool& pool);
    void advect_faces(const VelocityField& from, float dt_s, core::ThreadPool& pool);

    FlowParameters parameters_;
    const Kernels* kernels_;
    Walls walls_;
    Projection projection_;
    Advection advection_;
    bool is_followed_ = false;  ///< whether the advection has the velocity as it is
    std::array<std::optional<Diffusion>, 4> diffusions_;
    VelocityField velocity_, advected_, reflected_;
    std::array<grid::BoxField, kMaxFieldsTogether> cells_;
};

}  // namespace pastoso::liquid
