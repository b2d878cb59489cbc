#include "liquid/classic/source_lattice.hpp"

#include "core/check.hpp"
#include "liquid/classic/periodic.hpp"
#include "liquid/flow/sampling.hpp"
#include "liquid/flow/slices.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace pastoso::liquid {
namespace {

float wrapped(float position_m, float box_m) {
    const float inside = position_m - box_m * std::floor(position_m / box_m);
    return inside < box_m ? inside : 0.0F;
}

std::array<FourierBox, 3> spectra_of(const grid::BoxShape& shape) {
    const FourierExtent extent{shape.nx, shape.ny, shape.nz};
    return {FourierBox(extent), FourierBox(extent), FourierBox(extent)};
}

}  // namespace

glm::vec3 wrapped(const glm::vec3& point_m, float box_m) {
    return {wrapped(point_m.x, box_m), wrapped(point_m.y, box_m), wrapped(point_m.z, box_m)};
}

SourceLattice::SourceLattice(const grid::BoxShape& shape)
    : u_{grid::BoxField(shape), grid::BoxField(shape), grid::BoxField(shape)},
      carried_(u_),
      spectra_(spectra_of(shape)) {
    PASTOSO_CHECK(shape.nx == shape.ny && shape.ny == shape.nz);
}

void SourceLattice::step(float dt_s, float viscosity_m2_s, core::ThreadPool& pool) {
    fill_ghosts(pool);
    carry_velocity(dt_s, pool);
    diffuse_and_project(viscosity_m2_s * dt_s, pool);
    fill_ghosts(pool);
}

glm::vec3 SourceLattice::velocity_at(const glm::vec3& point_m) const {
    const grid::BoxShape& shape = u_[0].shape();
    const glm::vec3 inside_m = wrapped(point_m, static_cast<float>(shape.nx) * shape.cell_m);
    const auto sampled = [&](int axis) {
        return sample(along(axis), Location::Cell, inside_m, Interpolation::Cubic);
    };
    return {sampled(0), sampled(1), sampled(2)};
}

void SourceLattice::carry_velocity(float dt_s, core::ThreadPool& pool) {
    const grid::BoxShape& shape = u_[0].shape();
    for_slices(pool, 0, shape.nz, [&](int k) {
        for (int j = 0; j < shape.ny; ++j)
            for (int i = 0; i < shape.nx; ++i) {
                const glm::vec3 here_m = shape.cell_m * (glm::vec3(i, j, k) + 0.5F);
                const glm::vec3 halfway_m = here_m - 0.5F * dt_s * velocity_at(here_m);
                const glm::vec3 found = velocity_at(here_m - dt_s * velocity_at(halfway_m));
                for (const int axis : kAxes)
                    carried_[static_cast<std::size_t>(axis)].at(i, j, k) = found[axis];
            }
    });
}

void SourceLattice::diffuse_and_project(float spread_m2, core::ThreadPool& pool) {
    const int cells = u_[0].shape().nx;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        for_slices(pool, 0, cells, [&](int k) {
            for (int j = 0; j < cells; ++j)
                std::copy_n(carried_[axis].row(j, k), cells, spectra_[axis].real_row(j, k));
        });
        spectra_[axis].forward(pool);
    }
    for_slices(pool, 0, cells, [&](int k) {
        for (int j = 0; j < cells; ++j)
            project_row(j, k, spread_m2);
    });
    for (std::size_t axis = 0; axis < 3; ++axis) {
        spectra_[axis].backward(pool);
        for_slices(pool, 0, cells, [&](int k) {
            for (int j = 0; j < cells; ++j)
                std::copy_n(spectra_[axis].real_row(j, k), cells, u_[axis].row(j, k));
        });
    }
}

/// A wave exp(i t . x / h) meets central differences as i sin(t) / h, and the Laplacian as
/// -(6 - 2 cos t_x - 2 cos t_y - 2 cos t_z) / h^2.
void SourceLattice::project_row(int j, int k, float spread_m2) {
    const int cells = u_[0].shape().nx;
    const auto cell_m = static_cast<double>(u_[0].shape().cell_m);
    const double scale = 1.0 / (static_cast<double>(cells) * cells * cells);
    const double viscous = static_cast<double>(spread_m2) / (cell_m * cell_m);
    const auto angle = [&](int frequency) { return 2.0 * std::numbers::pi * frequency / cells; };
    for (int i = 0; i < spectra_[0].extent().half(); ++i) {
        const std::array<double, 3> t = {angle(i), angle(j), angle(k)};
        const double laplace = 6.0 - 2.0 * (std::cos(t[0]) + std::cos(t[1]) + std::cos(t[2]));
        std::array<std::complex<double>, 3> w;
        std::complex<double> along_t = 0.0;  // sum of sin(t) w
        for (std::size_t axis = 0; axis < 3; ++axis) {
            w[axis] =
                std::complex<double>(spectra_[axis].row(j, k)[i]) * (scale / (1.0 + viscous * laplace));
            along_t += std::sin(t[axis]) * w[axis];
        }
        const bool is_mean = i == 0 && j == 0 && k == 0;
        for (std::size_t axis = 0; axis < 3; ++axis) {
            const std::complex<double> gradient = is_mean ? 0.0 : std::sin(t[axis]) * along_t / laplace;
            spectra_[axis].row(j, k)[i] = std::complex<float>(w[axis] - gradient);
        }
    }
}

void SourceLattice::fill_ghosts(core::ThreadPool& pool) {
    for (grid::BoxField& field : u_)
        fill_periodic_ghosts(field, pool);
}

}  // namespace pastoso::liquid
