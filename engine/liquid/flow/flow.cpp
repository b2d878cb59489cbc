#include "liquid/flow/flow.hpp"

#include "core/check.hpp"
#include "core/error.hpp"
#include "liquid/flow/confinement.hpp"
#include "liquid/flow/reflection.hpp"
#include "liquid/flow/slices.hpp"

#include <cmath>
#include <string>

namespace pastoso::liquid {
namespace {

std::array<RowRanges, 4> all_rows(const Walls& walls) {
    return {walls.rows(Location::FaceX), walls.rows(Location::FaceY), walls.rows(Location::FaceZ),
            walls.rows(Location::Cell)};
}

void check_step(float dt_s) {
    if (!(dt_s >= 0.0F) || !std::isfinite(dt_s))
        throw core::InputError("The time step is %1 s; it must be 0 or more.", std::to_string(dt_s));
}

}  // namespace

void check(const FlowParameters& parameters) {
    if (!(parameters.viscosity_m2_s >= 0.0F) || !std::isfinite(parameters.viscosity_m2_s))
        throw core::InputError("The viscosity is %1 m2/s; it must be 0 or more.",
                               std::to_string(parameters.viscosity_m2_s));
    if (!(parameters.confinement >= 0.0F && parameters.confinement <= kMostConfinement))
        throw core::InputError("The vorticity confinement is %1; it may be 0 to 0.3.",
                               std::to_string(parameters.confinement));
    check(parameters.pressure);
    check(parameters.diffusion);
}

VesselFlow::VesselFlow(const grid::BoxShape& shape, const SignedDistance& distance,
                       const FlowParameters& parameters, const Kernels& kernels)
    : parameters_((check(parameters), parameters)),
      kernels_(&kernels),
      walls_(shape, distance),
      projection_(walls_, kernels),
      advection_(shape, all_rows(walls_), Edges::Walls, kernels, WaysOf::Cells),
      velocity_(shape),
      advected_(shape) {}

void VesselFlow::set_parameters(const FlowParameters& parameters) {
    check(parameters);
    if (parameters.friction != parameters_.friction)
        for (auto& diffusion : diffusions_)
            diffusion.reset();
    parameters_ = parameters;
}

void VesselFlow::confine_vorticity(float dt_s, core::ThreadPool& pool) {
    check_step(dt_s);
    if (parameters_.confinement > 0.0F)
        add_confinement(walls_, parameters_.confinement, dt_s, velocity(), pool);
}

SolveResult VesselFlow::diffuse_velocity(float dt_s, core::ThreadPool& pool) {
    is_followed_ = false;
    SolveResult worst;
    for (const int axis : kAxes) {
        auto& diffusion = diffusions_[static_cast<std::size_t>(axis)];
        if (!diffusion) diffusion.emplace(walls_, face_across(axis), parameters_.friction, *kernels_);
        const SolveResult result =
            diffusion->diffuse(walls_, velocity_.along(axis), parameters_.viscosity_m2_s, dt_s,
                               parameters_.diffusion, pool);
        worst = {std::max(worst.iterations, result.iterations),
                 std::max(worst.residual, result.residual), worst.converged && result.converged};
    }
    return worst;
}

SolveResult VesselFlow::project(core::ThreadPool& pool) {
    is_followed_ = false;
    return projection_.project(walls_, velocity_, parameters_.pressure, pool);
}

SolveResult VesselFlow::diffuse_cells(grid::BoxField& field, float diffusivity_m2_s, float dt_s,
                                      core::ThreadPool& pool) {
    auto& diffusion = diffusions_[static_cast<std::size_t>(Location::Cell)];
    if (!diffusion) diffusion.emplace(walls_, Location::Cell, parameters_.friction, *kernels_);
    return diffusion->diffuse(walls_, field, diffusivity_m2_s, dt_s, parameters_.diffusion, pool);
}

double VesselFlow::sum_over_cells(const grid::BoxField& field, core::ThreadPool& pool) const {
    return sum_over_slices(pool, shape().nz, [&](int k) {
        double sum = 0.0;
        for (int j = 0; j < shape().ny; ++j) {
            const RowRange range = walls_.rows(Location::Cell).at(j, k);
            if (range.empty()) continue;
            sum += kernels_->sum_of_products(walls_.open_cells().row(j, k) + range.begin,
                                             field.row(j, k) + range.begin, range.end - range.begin);
        }
        return sum;
    });
}

void VesselFlow::advect_cells(std::span<grid::BoxField* const> fields, float dt_s, KeepSum keep,
                              core::ThreadPool& pool) {
    check_step(dt_s);
    PASTOSO_CHECK_OP(fields.size(), <=, kMaxFieldsTogether);
    std::array<AdvectedPair, kMaxFieldsTogether> pairs{};
    std::array<double, kMaxFieldsTogether> sums{};
    for (std::size_t f = 0; f < fields.size(); ++f) {
        PASTOSO_CHECK(fields[f]->shape() == shape());
        if (cells_[f].values().empty()) cells_[f] = grid::BoxField(shape());
        if (keep == KeepSum::Yes) sums[f] = sum_over_cells(*fields[f], pool);
        walls_.extrapolate(*fields[f], Location::Cell, pool);
        pairs[f] = {fields[f], &cells_[f]};
    }
    follow(pool);
    advection_.advect(std::span(pairs).first(fields.size()), Location::Cell, dt_s,
                      parameters_.interpolation, pool);
    for (std::size_t f = 0; f < fields.size(); ++f) {
        std::swap(*fields[f], cells_[f]);
        if (keep == KeepSum::Yes) scale_to_sum(*fields[f], sums[f], pool);
    }
}

void VesselFlow::scale_to_sum(grid::BoxField& field, double sum, core::ThreadPool& pool) const {
    const double before = sum_over_cells(field, pool);
    if (!(std::abs(before) > 0.0) || !(before * sum > 0.0)) return;
    const float factor = static_cast<float>(sum / before);
    for_slices(pool, 0, shape().nz, [&](int k) {
        for (int j = 0; j < shape().ny; ++j) {
            const RowRange range = walls_.rows(Location::Cell).at(j, k);
            float* values = field.row(j, k);
            for (int i = range.begin; i < range.end; ++i)
                values[i] *= factor;
        }
    });
}

void VesselFlow::carry(std::span<glm::vec3> points_m, float dt_s, core::ThreadPool& pool) const {
    check_step(dt_s);
    carry_points(points_m, velocity_, dt_s, Edges::Walls, Interpolation::Cubic, pool, *kernels_);
}

void VesselFlow::carry(std::span<glm::vec3> points_m, float dt_s) const {
    check_step(dt_s);
    carry_points(points_m, velocity_, dt_s, Edges::Walls, Interpolation::Cubic, *kernels_);
}

void VesselFlow::follow(core::ThreadPool& pool) {
    if (!is_followed_) advection_.follow(velocity_, pool);
    is_followed_ = true;
}

void VesselFlow::advect_faces(const VelocityField& from, float dt_s, core::ThreadPool& pool) {
    for (const int axis : kAxes) {
        const AdvectedPair pair = {&from.along(axis), &advected_.along(axis)};
        advection_.advect({&pair, 1}, face_across(axis), dt_s, parameters_.interpolation, pool);
    }
    std::swap(velocity_, advected_);
    is_followed_ = false;
}

SolveResult VesselFlow::advect_velocity(float dt_s, core::ThreadPool& pool) {
    check_step(dt_s);
    follow(pool);
    if (parameters_.velocity_advection == VelocityAdvection::Once) {
        advect_faces(velocity_, dt_s, pool);
        return {};
    }
    advect_faces(velocity_, 0.5F * dt_s, pool);
    reflected_ = velocity_;
    const SolveResult result = project(pool);
    reflect(reflected_, velocity_, pool);
    walls_.extrapolate(reflected_, pool);
    follow(pool);
    advect_faces(reflected_, 0.5F * dt_s, pool);
    return result;
}

}  // namespace pastoso::liquid
