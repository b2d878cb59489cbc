#include "liquid/classic/periodic.hpp"

#include "core/check.hpp"
#include "core/elementary.hpp"
#include "core/error.hpp"
#include "liquid/flow/reflection.hpp"
#include "liquid/flow/slices.hpp"

#include <cmath>
#include <cstring>
#include <numbers>
#include <string>

namespace pastoso::liquid {
namespace {

using Complex = std::complex<float>;

std::array<RowRanges, 4> whole_box(const grid::BoxShape& shape) {
    // Faces behind the last cells are copies of the first ones.
    const RowRanges cells = RowRanges::whole(shape, Location::Cell);
    return {cells, cells, cells, cells};
}

void check_rate(float diffusivity_m2_s, float dt_s) {
    if (!(diffusivity_m2_s >= 0.0F) || !std::isfinite(diffusivity_m2_s) || !(dt_s >= 0.0F) ||
        !std::isfinite(dt_s))
        throw core::InputError("A diffusivity of %1 m2/s over %2 s; both must be 0 or more.",
                               std::to_string(diffusivity_m2_s), std::to_string(dt_s));
}

}  // namespace

void fill_periodic_ghosts(grid::BoxField& field, core::ThreadPool& pool) {
    const grid::BoxShape& shape = field.shape();
    const int nx = shape.nx, ny = shape.ny, nz = shape.nz;
    constexpr int kBehind = grid::kBoxGhosts + 1;  // the face behind the last cell too
    const auto copy_row = [&](int to_j, int to_k, int j, int k) {
        std::memcpy(field.row(to_j, to_k) - grid::kBoxGhosts, field.row(j, k) - grid::kBoxGhosts,
                    sizeof(float) * static_cast<std::size_t>(nx + grid::kBoxGhosts + kBehind));
    };
    for_slices(pool, 0, nz, [&](int k) {
        for (int j = 0; j < ny; ++j) {
            float* row = field.row(j, k);
            for (int i = 1; i <= grid::kBoxGhosts; ++i)
                row[-i] = row[nx - i];
            for (int i = 0; i < kBehind; ++i)
                row[nx + i] = row[i];
        }
        for (int j = 1; j <= grid::kBoxGhosts; ++j)
            copy_row(-j, k, ny - j, k);
        for (int j = 0; j < kBehind; ++j)
            copy_row(ny + j, k, j, k);
    });
    for (int j = -grid::kBoxGhosts; j < ny + kBehind; ++j) {
        for (int k = 1; k <= grid::kBoxGhosts; ++k)
            copy_row(j, -k, j, nz - k);
        for (int k = 0; k < kBehind; ++k)
            copy_row(j, nz + k, j, k);
    }
}

PeriodicFlow::PeriodicFlow(const grid::BoxShape& shape, const FlowParameters& parameters,
                           const Kernels& kernels)
    : parameters_((check_box_shape(shape), check(parameters), parameters)),
      advection_(shape, whole_box(shape), Edges::Periodic, kernels),
      spectra_{FourierBox({shape.nx, shape.ny, shape.nz}), FourierBox({shape.nx, shape.ny, shape.nz}),
               FourierBox({shape.nx, shape.ny, shape.nz})},
      velocity_(shape),
      advected_(shape) {
    const std::array<int, 3> sizes = {shape.nx, shape.ny, shape.nz};
    for (std::size_t axis = 0; axis < 3; ++axis)
        for (int k = 0; k < sizes[axis]; ++k) {
            const int signed_k = 2 * k <= sizes[axis] ? k : k - sizes[axis];
            const double turn = 2.0 * std::numbers::pi * signed_k / sizes[axis];
            const double half_sine = std::sin(0.5 * turn),
                         wave_m = turn / static_cast<double>(shape.cell_m);
            // exp(it) - 1 without cancellation.
            axes_[axis].shift.emplace_back(static_cast<float>(-2.0 * half_sine * half_sine),
                                           static_cast<float>(std::sin(turn)));
            axes_[axis].shift_squared.push_back(static_cast<float>(4.0 * half_sine * half_sine));
            axes_[axis].wave_squared.push_back(wave_m * wave_m);
        }
}

void PeriodicFlow::set_parameters(const FlowParameters& parameters) {
    check(parameters);
    parameters_ = parameters;
}

void PeriodicFlow::load(const grid::BoxField& field, FourierBox& spectrum, core::ThreadPool& pool) {
    for_slices(pool, 0, shape().nz, [&](int k) {
        for (int j = 0; j < shape().ny; ++j)
            std::copy_n(field.row(j, k), shape().nx, spectrum.real_row(j, k));
    });
    spectrum.forward(pool);
}

void PeriodicFlow::store(FourierBox& spectrum, grid::BoxField& field, core::ThreadPool& pool) {
    spectrum.backward(pool);
    const float scale = 1.0F / (static_cast<float>(shape().nx) * static_cast<float>(shape().ny) *
                                static_cast<float>(shape().nz));
    for_slices(pool, 0, shape().nz, [&](int k) {
        for (int j = 0; j < shape().ny; ++j)
            for (int i = 0; i < shape().nx; ++i)
                field.at(i, j, k) = scale * spectrum.real_row(j, k)[i];
    });
    fill_periodic_ghosts(field, pool);
}

PeriodicFlow::AxisDecays PeriodicFlow::decays(float diffusivity_m2_s, float dt_s) const {
    // exp(-x) is 0 in single precision beyond.
    constexpr double kMostDecay = 200.0;
    const double rate_m2 = static_cast<double>(diffusivity_m2_s) * static_cast<double>(dt_s);
    AxisDecays decays;
    for (std::size_t axis = 0; axis < 3; ++axis)
        for (const double wave_squared : axes_[axis].wave_squared)
            decays[axis].push_back(
                static_cast<float>(core::exponential(-std::min(rate_m2 * wave_squared, kMostDecay))));
    return decays;
}

void PeriodicFlow::project_row(int j, int k, const AxisDecays& decays) {
    const auto& [x, y, z] = axes_;
    const auto jj = static_cast<std::size_t>(j), kk = static_cast<std::size_t>(k);
    const std::array<Complex*, 3> u = {spectra_[0].row(j, k), spectra_[1].row(j, k),
                                       spectra_[2].row(j, k)};
    const float rest = decays[1][jj] * decays[2][kk];
    for (int i = 0; i <= shape().nx / 2; ++i) {
        const auto ii = static_cast<std::size_t>(i);
        const std::array<Complex, 3> d = {x.shift[ii], y.shift[jj], z.shift[kk]};
        const float squared = x.shift_squared[ii] + y.shift_squared[jj] + z.shift_squared[kk];
        float re = 0.0F, im = 0.0F;  // d . u / |d|^2
        for (std::size_t axis = 0; axis < 3; ++axis) {
            re += d[axis].real() * u[axis][i].real() - d[axis].imag() * u[axis][i].imag();
            im += d[axis].real() * u[axis][i].imag() + d[axis].imag() * u[axis][i].real();
        }
        const float inverse = squared > 0.0F ? 1.0F / squared : 0.0F;
        re *= inverse;
        im *= inverse;
        const float decay = decays[0][ii] * rest;
        for (std::size_t axis = 0; axis < 3; ++axis)
            u[axis][i] = {decay * (u[axis][i].real() - (d[axis].real() * re + d[axis].imag() * im)),
                          decay * (u[axis][i].imag() - (d[axis].real() * im - d[axis].imag() * re))};
    }
}

void PeriodicFlow::diffuse_and_project(float dt_s, core::ThreadPool& pool) {
    check_rate(parameters_.viscosity_m2_s, dt_s);
    for (const int axis : kAxes)
        load(velocity_.along(axis), spectra_[static_cast<std::size_t>(axis)], pool);
    const AxisDecays decay = decays(parameters_.viscosity_m2_s, dt_s);
    for_slices(pool, 0, shape().nz, [&](int k) {
        for (int j = 0; j < shape().ny; ++j)
            project_row(j, k, decay);
    });
    for (const int axis : kAxes)
        store(spectra_[static_cast<std::size_t>(axis)], velocity_.along(axis), pool);
}

void PeriodicFlow::carry(std::span<glm::vec3> points_m, float dt_s, core::ThreadPool& pool) const {
    carry_points(points_m, velocity_, dt_s, Edges::Periodic, Interpolation::Cubic, pool);
}

void PeriodicFlow::advect_faces(const VelocityField& from, float dt_s, core::ThreadPool& pool) {
    for (const int axis : kAxes) {
        const AdvectedPair pair = {&from.along(axis), &advected_.along(axis)};
        advection_.advect({&pair, 1}, face_across(axis), dt_s, parameters_.interpolation, pool);
    }
    std::swap(velocity_, advected_);
    for (const int axis : kAxes)
        fill_periodic_ghosts(velocity_.along(axis), pool);
}

void PeriodicFlow::advect_velocity(float dt_s, core::ThreadPool& pool) {
    check_rate(0.0F, dt_s);
    advection_.follow(velocity_, pool);
    if (parameters_.velocity_advection == VelocityAdvection::Once)
        return advect_faces(velocity_, dt_s, pool);
    advect_faces(velocity_, 0.5F * dt_s, pool);
    reflected_ = velocity_;
    project(pool);
    reflect(reflected_, velocity_, pool);
    advection_.follow(velocity_, pool);
    advect_faces(reflected_, 0.5F * dt_s, pool);
}

}  // namespace pastoso::liquid
