// The flow in a box that repeats in all directions: what leaves on one side comes in on the other.
// Viscosity and pressure are exact in Fourier space. With the shifts t = (2 pi k_x / n_x, ..) between a
// face and the next, the discrete divergence is d . u with d = exp(i t) - 1, and
//     u <- exp(-nu |k|^2 dt) (u - conj(d) (d . u) / |d|^2)
// leaves none, in one pass of three transforms there and three back.
#pragma once

#include "liquid/classic/fourier.hpp"
#include "liquid/flow/advection.hpp"
#include "liquid/flow/flow.hpp"

namespace pastoso::liquid {

/// Copies the samples of a periodic field into the ghosts around the box, and to the faces behind the
/// last cells.
void fill_periodic_ghosts(grid::BoxField& field, core::ThreadPool& pool);

/// Uses viscosity, velocity_advection and interpolation of the parameters; the pressure is exact.
class PeriodicFlow {
  public:
    /// The fluid at rest. Throws core::InputError for a bad shape or parameter.
    explicit PeriodicFlow(const grid::BoxShape& shape, const FlowParameters& parameters = {},
                          const Kernels& kernels = core::kernels<Kernels>());

    const grid::BoxShape& shape() const { return velocity_.shape(); }
    const FlowParameters& parameters() const { return parameters_; }
    void set_parameters(const FlowParameters& parameters);

    /// Faces 0 to n - 1 along each axis count; project() fills the rest.
    VelocityField& velocity() { return velocity_; }
    const VelocityField& velocity() const { return velocity_; }

    /// Viscosity over dt_s and pressure together.
    void diffuse_and_project(float dt_s, core::ThreadPool& pool);
    void project(core::ThreadPool& pool) { diffuse_and_project(0.0F, pool); }
    void carry(std::span<glm::vec3> points_m, float dt_s, core::ThreadPool& pool) const;
    /// Leaves the velocity with divergence: the next step's projection removes it.
    void advect_velocity(float dt_s, core::ThreadPool& pool);

  private:
    /// Of one axis and each frequency: exp(i t) - 1, its |.|^2, and the wave number's square in 1/m2.
    struct Axis {
        std::vector<std::complex<float>> shift;
        std::vector<float> shift_squared;
        std::vector<double> wave_squared;
    };
    /// exp(-nu k^2 dt) is a product over the axes.
    using AxisDecays = std::array<std::vector<float>, 3>;
    AxisDecays decays(float diffusivity_m2_s, float dt_s) const;
    void load(const grid::BoxField& field, FourierBox& spectrum, core::ThreadPool& pool);
    void store(FourierBox& spectrum, grid::BoxField& field, core::ThreadPool& pool);
    void project_row(int j, int k, const AxisDecays& decays);
    void advect_faces(const VelocityField& from, float dt_s, core::ThreadPool& pool);

    FlowParameters parameters_;
    Advection advection_;
    std::array<Axis, 3> axes_;
    std::array<FourierBox, 3> spectra_;
    VelocityField velocity_, advected_, reflected_;
};

}  // namespace pastoso::liquid
