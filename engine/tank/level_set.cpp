#include "tank/level_set.hpp"

#include "core/check.hpp"
#include "liquid/flow/slices.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

namespace pastoso::tank {
namespace {

using liquid::RowRange;
using liquid::RowRanges;

/// |phi| in the band. Less rounding: what lies beyond is the reach itself.
float band_m(const grid::BoxShape& shape, float reach_cells) {
    return reach_cells * shape.cell_m * 0.99999F;
}

/// Beyond both ends of a line of `count` samples.
void continue_line(float* first, std::ptrdiff_t step, int count) {
    float* last = first + (count - 1) * step;
    const float slope_before = first[0] - first[step], slope_behind = last[0] - last[-step];
    for (int ghost = 1; ghost <= grid::kBoxGhosts; ++ghost) {
        first[-ghost * step] = first[0] + static_cast<float>(ghost) * slope_before;
        last[ghost * step] = last[0] + static_cast<float>(ghost) * slope_behind;
    }
}

/// Twice the velocity at the middle of a cell, and the sum of its components' sizes.
struct TwiceVelocity {
    float x, y, z;
    float size() const { return std::abs(x) + std::abs(y) + std::abs(z); }
};
TwiceVelocity twice_velocity(const liquid::VelocityField& velocity, int i, int j, int k) {
    return {velocity.x.at(i, j, k) + velocity.x.at(i + 1, j, k),
            velocity.y.at(i, j, k) + velocity.y.at(i, j + 1, k),
            velocity.z.at(i, j, k) + velocity.z.at(i, j, k + 1)};
}

/// Calls body(i, j) for a slice's cells with |phi| < within_m.
template <class Body>
void for_band(const grid::BoxField& phi, float within_m, const RowRanges& rows, int k,
              const Body& body) {
    for (int j = 0; j < phi.shape().ny; ++j) {
        const RowRange row = rows.at(j, k);
        const float* values = phi.row(j, k);
        for (int i = row.begin; i < row.end; ++i)
            if (std::abs(values[i]) < within_m) body(i, j);
    }
}

/// The largest |u| + |v| + |w| at middles in the band.
float largest_size(const grid::BoxField& phi, float within_m, const RowRanges& rows,
                   const liquid::VelocityField& velocity, core::ThreadPool& pool) {
    const int slices = phi.shape().nz;
    std::vector<float> largest(static_cast<std::size_t>(slices), 0.0F);
    liquid::for_slices(pool, 0, slices, [&](int k) {
        float& most = largest[static_cast<std::size_t>(k)];
        for_band(phi, within_m, rows, k, [&](int i, int j) {
            most = std::max(most, 0.5F * twice_velocity(velocity, i, j, k).size());
        });
    });
    return *std::max_element(largest.begin(), largest.end());
}

/// Twice u d phi/dx times the cell's side, on the side that the flow comes from.
float upwind(const float* phi, std::ptrdiff_t step, float twice_speed) {
    return twice_speed * (twice_speed > 0.0F ? phi[0] - phi[-step] : phi[step] - phi[0]);
}

}  // namespace

void continue_beyond_walls(grid::BoxField& phi) {
    constexpr int kGhosts = grid::kBoxGhosts;
    const grid::BoxShape& shape = phi.shape();
    for (int k = 0; k < shape.nz; ++k) {
        for (int j = 0; j < shape.ny; ++j)
            continue_line(phi.row(j, k), 1, shape.nx);
        for (int i = -kGhosts; i < shape.nx + kGhosts; ++i)
            continue_line(phi.row(0, k) + i, shape.stride_y(), shape.ny);
    }
    for (int j = -kGhosts; j < shape.ny + kGhosts; ++j)
        for (int i = -kGhosts; i < shape.nx + kGhosts; ++i)
            continue_line(phi.row(j, 0) + i, shape.stride_z(), shape.nz);
}

RowRanges band_rows(const grid::BoxField& phi, float reach_cells, core::ThreadPool& pool) {
    const grid::BoxShape& shape = phi.shape();
    const float within_m = band_m(shape, reach_cells);
    RowRanges rows(shape);
    liquid::for_slices(pool, 0, shape.nz, [&](int k) {
        for (int j = 0; j < shape.ny; ++j) {
            const float* row = phi.row(j, k);
            int begin = 0, end = shape.nx;
            while (begin < end && !(std::abs(row[begin]) < within_m))
                ++begin;
            while (end > begin && !(std::abs(row[end - 1]) < within_m))
                --end;
            if (begin < end) rows.at(j, k) = {begin, end};
        }
    });
    return rows;
}

LevelSetAdvection::LevelSetAdvection(const grid::BoxShape& shape, const liquid::Kernels& kernels)
    : advection_(shape, {RowRanges(shape), RowRanges(shape), RowRanges(shape), RowRanges(shape)},
                 liquid::Edges::Walls, kernels),
      before_(shape) {}

void LevelSetAdvection::advect(grid::BoxField& phi, const liquid::VelocityField& velocity, float dt_s,
                               float reach_cells, LevelSetScheme scheme, core::ThreadPool& pool,
                               liquid::Interpolation interpolation) {
    PASTOSO_CHECK(phi.shape() == before_.shape());
    PASTOSO_CHECK(velocity.shape() == before_.shape());
    const RowRanges rows = band_rows(phi, reach_cells, pool);
    if (scheme == LevelSetScheme::Upwind)
        return advect_upwind(phi, velocity, dt_s, reach_cells, rows, pool);
    before_ = phi;
    const RowRanges none(phi.shape());
    advection_.set_rows({none, none, none, rows});
    advection_.follow(velocity, pool);
    const liquid::AdvectedPair pair{&before_, &phi};
    advection_.advect({&pair, 1}, liquid::Location::Cell, dt_s, interpolation, pool);
    restore_beyond(reach_cells, rows, phi, pool);
    continue_beyond_walls(phi);
}

void LevelSetAdvection::restore_beyond(float reach_cells, const RowRanges& rows, grid::BoxField& phi,
                                       core::ThreadPool& pool) const {
    const float within_m = band_m(phi.shape(), reach_cells);
    liquid::for_slices(pool, 0, phi.shape().nz, [&](int k) {
        for (int j = 0; j < phi.shape().ny; ++j) {
            const RowRange row = rows.at(j, k);
            const float* before = before_.row(j, k);
            float* after = phi.row(j, k);
            for (int i = row.begin; i < row.end; ++i)
                after[i] = std::abs(before[i]) < within_m ? after[i] : before[i];
        }
    });
}

void LevelSetAdvection::advect_upwind(grid::BoxField& phi, const liquid::VelocityField& velocity,
                                      float dt_s, float reach_cells, const RowRanges& rows,
                                      core::ThreadPool& pool) {
    const grid::BoxShape& shape = phi.shape();
    const float within_m = band_m(shape, reach_cells);
    const float way_cells = largest_size(phi, within_m, rows, velocity, pool) * dt_s / shape.cell_m;
    const int parts = std::max(1, static_cast<int>(std::ceil(way_cells)));
    const float half_step = 0.5F * dt_s / (static_cast<float>(parts) * shape.cell_m);
    for (int part = 0; part < parts; ++part) {
        before_ = phi;
        liquid::for_slices(pool, 0, shape.nz, [&](int k) {
            for_band(before_, within_m, rows, k, [&](int i, int j) {
                const float* here = before_.row(j, k) + i;
                const TwiceVelocity twice = twice_velocity(velocity, i, j, k);
                phi.at(i, j, k) -=
                    half_step * (upwind(here, 1, twice.x) + upwind(here, shape.stride_y(), twice.y) +
                                 upwind(here, shape.stride_z(), twice.z));
            });
        });
        continue_beyond_walls(phi);
    }
}

}  // namespace pastoso::tank
