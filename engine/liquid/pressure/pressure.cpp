#include "liquid/pressure/pressure.hpp"

#include "liquid/flow/slices.hpp"

#include <algorithm>
#include <cmath>

namespace pastoso::liquid {
namespace {

void compute_inflow_row(const Kernels& kernels, const Walls& walls, const VelocityField& velocity, int j,
                        int k, float* out) {
    const RowRange range = walls.rows(Location::Cell).at(j, k);
    if (range.empty()) return;
    kernels.compute_inflow(face_rows(walls.open(), range.begin, j, k),
                           face_rows(velocity, range.begin, j, k), range.end - range.begin,
                           out + range.begin);
}

}  // namespace

CellMatrix pressure_matrix(const Walls& walls) {
    CellMatrix matrix(walls.shape());
    matrix.faces = walls.open();
    return matrix;
}

Projection::Projection(const Walls& walls, const Kernels& kernels)
    : kernels_(&kernels),
      solver_(pressure_matrix(walls), kernels),
      pressure_(walls.shape()),
      source_(walls.shape()) {}

void Projection::start_cold() {
    std::ranges::fill(pressure_.values(), 0.0F);
}

SolveResult Projection::project(const Walls& walls, VelocityField& velocity, const SolveLimits& limits,
                                core::ThreadPool& pool) {
    const grid::BoxShape& shape = walls.shape();
    for_slices(pool, 0, shape.nz, [&](int k) {
        for (int j = 0; j < shape.ny; ++j)
            compute_inflow_row(*kernels_, walls, velocity, j, k, source_.row(j, k));
    });
    const SolveResult result = solver_.solve(source_, pressure_, limits, pool);
    for_slices(pool, 0, shape.nz, [&](int k) {
        for (int j = 0; j < shape.ny; ++j)
            for (const int axis : kAxes) {
                const RowRange range = walls.rows(face_across(axis)).at(j, k);
                if (range.empty()) continue;
                kernels_->subtract_gradient(walls.open().along(axis).row(j, k) + range.begin,
                                            pressure_.row(j, k) + range.begin, stride(shape, axis),
                                            range.end - range.begin,
                                            velocity.along(axis).row(j, k) + range.begin);
            }
    });
    walls.extrapolate(velocity, pool);
    return result;
}

float largest_divergence(const Walls& walls, const VelocityField& velocity, core::ThreadPool& pool) {
    const grid::BoxShape& shape = walls.shape();
    std::vector<float> largest(static_cast<std::size_t>(shape.nz), 0.0F);
    for_slices(pool, 0, shape.nz, [&](int k) {
        std::vector<float> inflow(static_cast<std::size_t>(shape.nx), 0.0F);
        float& most = largest[static_cast<std::size_t>(k)];
        for (int j = 0; j < shape.ny; ++j) {
            const RowRange range = walls.rows(Location::Cell).at(j, k);
            compute_inflow_row(core::kernels<Kernels>(), walls, velocity, j, k, inflow.data());
            for (int i = range.begin; i < range.end; ++i)
                most = std::max(most, std::abs(inflow[static_cast<std::size_t>(i)]));
        }
    });
    return *std::ranges::max_element(largest) / shape.cell_m;
}

}  // namespace pastoso::liquid
