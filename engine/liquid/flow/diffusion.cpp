#include "liquid/flow/diffusion.hpp"

#include "core/error.hpp"
#include "liquid/flow/slices.hpp"

#include <cmath>
#include <string>

namespace pastoso::liquid {
namespace {

void check_rate(float diffusivity_m2_s, float dt_s) {
    if (!(diffusivity_m2_s >= 0.0F) || !std::isfinite(diffusivity_m2_s))
        throw core::InputError("The diffusivity or viscosity is %1 m2/s; it must be 0 or more.",
                               std::to_string(diffusivity_m2_s));
    if (!(dt_s >= 0.0F) || !std::isfinite(dt_s))
        throw core::InputError("The time step is %1 s; it must be 0 or more.", std::to_string(dt_s));
}

const grid::BoxField& known_samples(const Region& region, Location location) {
    return location == Location::Cell ? region.open_cells()
                                      : region.open().along(static_cast<int>(location));
}

/// How many stages of Legendre's polynomials a step needs, each worth the more the more there are.
int stages_for(float step) {
    int stages = 1;
    while (stages <= kMaxStages &&
           kLongestExplicitStep * 0.5F * static_cast<float>(stages * (stages + 1)) < step)
        ++stages;
    return stages;
}

}  // namespace

Diffusion::Diffusion(const Region& region, Location location, WallFriction friction,
                     const Kernels& kernels)
    : location_(location), friction_(friction), kernels_(&kernels), next_(region.shape()) {}

SolveResult Diffusion::diffuse(const Region& region, grid::BoxField& field, float diffusivity_m2_s,
                               float dt_s, const SolveLimits& limits, core::ThreadPool& pool) {
    check_rate(diffusivity_m2_s, dt_s);
    const float cell = region.shape().cell_m, step = diffusivity_m2_s * dt_s / (cell * cell);
    if (!std::isfinite(step))
        throw core::InputError("A diffusivity or viscosity of %1 m2/s is too large for a step of %2 s.",
                               std::to_string(diffusivity_m2_s), std::to_string(dt_s));
    if (step == 0.0F) return {};
    const float sub_steps = std::ceil(step / kLongestExplicitStep);
    if (sub_steps <= static_cast<float>(kMaxExplicitSteps)) {
        for (int n = 0; n < static_cast<int>(sub_steps); ++n) {
            apply(region, {1.0F, 0.0F, step / sub_steps}, field, next_, pool);
            copy_back(region, field, pool);
        }
        return {};
    }
    const int stages = stages_for(step);
    if (stages > kMaxStages) return implicit_step(region, field, step, limits, pool);
    legendre_step(region, field, step, stages, pool);
    return {};
}

/// Stage j of s, with L the Laplacian and w = 2 / (s^2 + s):
///     j Y(j) = (2j - 1) (Y(j-1) + w step L Y(j-1)) - (j - 1) Y(j-2).
/// Y(j) takes the place of Y(j-2).
void Diffusion::legendre_step(const Region& region, grid::BoxField& field, float step, int stages,
                              core::ThreadPool& pool) {
    const float part = 2.0F * step / static_cast<float>(stages * (stages + 1));
    for (int j = 1; j <= stages; ++j) {
        const float n = static_cast<float>(j), here = (2.0F * n - 1.0F) / n;
        const bool odd = j % 2 == 1;
        apply(region, {here, (1.0F - n) / n, here * part}, odd ? field : next_, odd ? next_ : field,
              pool);
    }
    if (stages % 2 == 1) copy_back(region, field, pool);
}

void Diffusion::apply(const Region& region, const Stage& stage, const grid::BoxField& from,
                      grid::BoxField& to, core::ThreadPool& pool) const {
    const grid::BoxShape& shape = region.shape();
    for_slices(pool, 0, shape.nz, [&](int k) {
        for (int j = 0; j < shape.ny; ++j) {
            const RowRange range = region.rows(location_).at(j, k);
            if (range.empty()) continue;
            const DiffusedRow row = {from.row(j, k) + range.begin, to.row(j, k) + range.begin,
                                     range.end - range.begin};
            if (location_ == Location::Cell)
                kernels_->diffuse_cells(face_rows(region.open(), range.begin, j, k), stage, row);
            else
                kernels_->diffuse_faces(known_samples(region, location_).row(j, k) + range.begin,
                                        shape.stride_y(), shape.stride_z(),
                                        friction_ == WallFriction::Sticks, stage, row);
        }
    });
}

void Diffusion::copy_back(const Region& region, grid::BoxField& field, core::ThreadPool& pool) const {
    const grid::BoxShape& shape = region.shape();
    for_slices(pool, 0, shape.nz, [&](int k) {
        for (int j = 0; j < shape.ny; ++j) {
            const RowRange range = region.rows(location_).at(j, k);
            if (range.empty()) continue;
            std::copy(next_.row(j, k) + range.begin, next_.row(j, k) + range.end,
                      field.row(j, k) + range.begin);
        }
    });
}

float Diffusion::passage(const Region& region, int axis, std::ptrdiff_t index) const {
    if (location_ == Location::Cell)
        return region.open().along(axis).values()[static_cast<std::size_t>(index)];
    const auto& known = known_samples(region, location_).values();
    const auto before = static_cast<std::size_t>(index - stride(region.shape(), axis));
    return known[static_cast<std::size_t>(index)] > 0.0F && known[before] > 0.0F ? 1.0F : 0.0F;
}

float Diffusion::wall_passages(const Region& region, std::ptrdiff_t index) const {
    if (location_ == Location::Cell || friction_ == WallFriction::Slips) return 0.0F;
    const auto& known = known_samples(region, location_).values();
    float count = 0.0F;
    for (const int axis : kAxes)
        for (const std::ptrdiff_t step : {-stride(region.shape(), axis), stride(region.shape(), axis)})
            if (!(known[static_cast<std::size_t>(index + step)] > 0.0F)) count += 1.0F;
    return count;
}

CellMatrix Diffusion::implicit_matrix(const Region& region, float step) const {
    const grid::BoxShape& shape = region.shape();
    const grid::BoxField& known = known_samples(region, location_);
    CellMatrix matrix(shape);
    for (int k = 0; k < shape.nz; ++k)
        for (int j = 0; j < shape.ny; ++j)
            for (int i = 0; i < shape.nx; ++i) {
                if (!(known.at(i, j, k) > 0.0F)) continue;
                const std::ptrdiff_t index = shape.index(i, j, k);
                for (const int axis : kAxes)
                    matrix.faces.along(axis).at(i, j, k) = step * passage(region, axis, index);
                matrix.boundary.at(i, j, k) = step * wall_passages(region, index);
                matrix.mass.at(i, j, k) = 1.0F;
            }
    return matrix;
}

SolveResult Diffusion::implicit_step(const Region& region, grid::BoxField& field, float step,
                                     const SolveLimits& limits, core::ThreadPool& pool) {
    const grid::BoxShape& shape = region.shape();
    if (solver_step_ != step) {
        if (solver_ == nullptr) solver_ = std::make_unique<ConjugateGradients>(shape, *kernels_);
        solver_->set_matrix(implicit_matrix(region, step), RowRanges::whole(shape, Location::Cell),
                            pool);
        solver_step_ = step;
    }
    const grid::BoxField& known = known_samples(region, location_);
    next_ = field;
    const SolveResult result = solver_->solve(field, next_, limits, pool);
    for_slices(pool, 0, shape.nz, [&](int k) {
        for (int j = 0; j < shape.ny; ++j) {
            const RowRange range = region.rows(location_).at(j, k);
            for (int i = range.begin; i < range.end; ++i)
                if (known.at(i, j, k) > 0.0F) field.at(i, j, k) = next_.at(i, j, k);
        }
    });
    return result;
}

}  // namespace pastoso::liquid
