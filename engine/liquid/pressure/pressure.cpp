#include "liquid/pressure/pressure.hpp"

#include "liquid/flow/slices.hpp"

#include <algorithm>
#include <cmath>

namespace pastoso::liquid {
namespace {

/// Minus the sum of w u over the faces of each cell of a row.
void outflow_row(const VelocityField& open, const VelocityField& velocity, RowRange range, int j, int k,
                 float* out) {
    const std::ptrdiff_t y = open.shape().stride_y(), z = open.shape().stride_z();
    const float *wx = open.x.row(j, k), *wy = open.y.row(j, k), *wz = open.z.row(j, k);
    const float *u = velocity.x.row(j, k), *v = velocity.y.row(j, k), *w = velocity.z.row(j, k);
    for (int i = range.begin; i < range.end; ++i)
        out[i] = ((wx[i] * u[i] - wx[i + 1] * u[i + 1]) + (wy[i] * v[i] - wy[i + y] * v[i + y])) +
                 (wz[i] * w[i] - wz[i + z] * w[i + z]);
}

void subtract_gradient(const grid::BoxField& open, const grid::BoxField& pressure, std::ptrdiff_t stride,
                       RowRange range, int j, int k, grid::BoxField& velocity) {
    const float *w = open.row(j, k), *p = pressure.row(j, k);
    float* u = velocity.row(j, k);
    for (int i = range.begin; i < range.end; ++i)
        u[i] = w[i] > 0.0F ? u[i] - (p[i] - p[i - stride]) : 0.0F;
}

}  // namespace

CellMatrix pressure_matrix(const Walls& walls) {
    CellMatrix matrix(walls.shape());
    matrix.faces = walls.open();
    return matrix;
}

Projection::Projection(const Walls& walls, const Kernels& kernels)
    : solver_(pressure_matrix(walls), kernels), pressure_(walls.shape()), source_(walls.shape()) {}

void Projection::start_cold() {
    std::ranges::fill(pressure_.values(), 0.0F);
}

SolveResult Projection::project(const Walls& walls, VelocityField& velocity, const SolveLimits& limits,
                                core::ThreadPool& pool) {
    const grid::BoxShape& shape = walls.shape();
    const RowRanges& cells = walls.rows(Location::Cell);
    for_slices(pool, 0, shape.nz, [&](int k) {
        for (int j = 0; j < shape.ny; ++j)
            outflow_row(walls.open(), velocity, cells.at(j, k), j, k, source_.row(j, k));
    });
    const SolveResult result = solver_.solve(source_, pressure_, limits, pool);
    for_slices(pool, 0, shape.nz, [&](int k) {
        for (int j = 0; j < shape.ny; ++j)
            for (const int axis : kAxes)
                subtract_gradient(walls.open().along(axis), pressure_, stride(shape, axis),
                                  walls.rows(face_across(axis)).at(j, k), j, k, velocity.along(axis));
    });
    walls.extrapolate(velocity, pool);
    return result;
}

float largest_divergence(const Walls& walls, const VelocityField& velocity) {
    const grid::BoxShape& shape = walls.shape();
    std::vector<float> outflow(static_cast<std::size_t>(shape.nx));
    float largest = 0.0F;
    for (int k = 0; k < shape.nz; ++k)
        for (int j = 0; j < shape.ny; ++j) {
            const RowRange range = walls.rows(Location::Cell).at(j, k);
            outflow_row(walls.open(), velocity, range, j, k, outflow.data());
            for (int i = range.begin; i < range.end; ++i)
                largest = std::max(largest, std::abs(outflow[static_cast<std::size_t>(i)]));
        }
    return largest / shape.cell_m;
}

}  // namespace pastoso::liquid
