#include "tank/free_surface.hpp"

#include "liquid/flow/slices.hpp"

#include <algorithm>
#include <utility>

namespace pastoso::tank {
namespace {

using liquid::kAxes;
using liquid::RowRange;

/// Where between a cell of liquid and one of air the surface lies.
float theta(float level, float level_beyond) {
    return std::max(level / (level - level_beyond), kLeastTheta);
}

}  // namespace

FreeSurface::FreeSurface(const Domain& domain, const liquid::Kernels& kernels)
    : domain_(&domain),
      solver_(domain.shape(), kernels),
      matrix_(domain.shape()),
      near_rows_(domain.shape()),
      rows_(domain.shape()),
      level_m_(domain.shape(), domain.shape().cell_m),
      liquid_(domain.shape()),
      pressure_(domain.shape()),
      source_(domain.shape()) {}

void FreeSurface::clear(core::ThreadPool& pool) {
    const grid::BoxShape& shape = domain_->shape();
    liquid::for_slices(pool, 0, shape.nz, [&](int k) {
        for (int j = 0; j < shape.ny; ++j) {
            const RowRange row = near_rows_.at(j, k);
            if (row.empty()) continue;
            for (grid::BoxField* field : {&matrix_.faces.x, &matrix_.faces.y, &matrix_.faces.z,
                                          &matrix_.boundary, &liquid_, &source_})
                std::fill(field->row(j, k) + row.begin, field->row(j, k) + row.end, 0.0F);
        }
    });
}

void FreeSurface::update(const liquid::RowRanges& rows, core::ThreadPool& pool) {
    const grid::BoxShape& shape = domain_->shape();
    clear(pool);
    near_rows_ = rows;
    liquid_cells_ = liquid::sum_over_slices(pool, shape.nz, [&](int k) {
        long count = 0;
        for (int j = 0; j < shape.ny; ++j) {
            const RowRange row = near_rows_.at(j, k);
            const float *level = level_m_.row(j, k), *open = domain_->walls().open_cells().row(j, k);
            float* liquid = liquid_.row(j, k);
            rows_.at(j, k) = {};
            for (int i = row.begin; i < row.end; ++i) {
                if (!(level[i] < 0.0F && open[i] > 0.0F)) continue;
                liquid[i] = 1.0F;
                rows_.include(i, j, k);
                ++count;
            }
        }
        return count;
    });
    liquid::for_slices(pool, 0, shape.nz, [&](int k) {
        for (int j = 0; j < shape.ny; ++j)
            build_row(j, k);
    });
}

void FreeSurface::build_row(int j, int k) {
    const grid::BoxShape& shape = domain_->shape();
    const RowRange row = rows_.at(j, k);
    const std::ptrdiff_t steps[] = {1, shape.stride_y(), shape.stride_z()};
    const float *liquid = liquid_.row(j, k), *level = level_m_.row(j, k);
    float* boundary = matrix_.boundary.row(j, k);
    for (const int axis : liquid::kAxes) {
        const std::ptrdiff_t step = steps[axis];
        const float* open = domain_->walls().open().along(axis).row(j, k);
        float* faces = matrix_.faces.along(axis).row(j, k);
        for (int i = row.begin; i < row.end; ++i) {
            if (!(liquid[i] > 0.0F)) continue;
            const float before = open[i], behind = open[i + step];
            const bool liquid_before = liquid[i - step] > 0.0F;
            if (liquid_before) faces[i] = before;
            if (!liquid_before && before > 0.0F)
                boundary[i] += before / theta(level[i], level[i - step]);
            if (!(liquid[i + step] > 0.0F) && behind > 0.0F)
                boundary[i] += behind / theta(level[i], level[i + step]);
        }
    }
}

liquid::Region FreeSurface::region() const {
    const grid::BoxShape& shape = domain_->shape();
    liquid::VelocityField open(shape);
    for (const int axis : kAxes) {
        const std::ptrdiff_t step = liquid::stride(shape, axis);
        for (int k = 0; k < shape.nz; ++k)
            for (int j = 0; j < shape.ny; ++j) {
                const RowRange row = near_rows_.at(j, k);
                const float *share = domain_->walls().open().along(axis).row(j, k),
                            *liquid = liquid_.row(j, k);
                float* out = open.along(axis).row(j, k);
                for (int i = row.begin; i < row.end; ++i)
                    if (liquid[i] > 0.0F || liquid[i - step] > 0.0F) out[i] = share[i];
            }
    }
    return liquid::Region(std::move(open));
}

/// Sum of w u over the faces of a cell.
float FreeSurface::divergence(const liquid::VelocityField& velocity, int i, int j, int k) const {
    const liquid::VelocityField& open = domain_->walls().open();
    const auto flux = [&](int axis, int di, int dj, int dk) {
        return open.along(axis).at(i + di, j + dj, k + dk) *
               velocity.along(axis).at(i + di, j + dj, k + dk);
    };
    return ((flux(0, 1, 0, 0) - flux(0, 0, 0, 0)) + (flux(1, 0, 1, 0) - flux(1, 0, 0, 0))) +
           (flux(2, 0, 0, 1) - flux(2, 0, 0, 0));
}

liquid::SolveResult FreeSurface::project(liquid::VelocityField& velocity,
                                         const grid::BoxField* growth_m_s,
                                         const liquid::SolveLimits& limits, core::ThreadPool& pool) {
    const grid::BoxShape& shape = domain_->shape();
    if (liquid_cells_ == 0) return {};
    liquid::for_slices(pool, 0, shape.nz, [&](int k) {
        for (int j = 0; j < shape.ny; ++j) {
            const RowRange row = rows_.at(j, k);
            for (int i = row.begin; i < row.end; ++i) {
                if (!is_liquid(i, j, k)) continue;
                const float growth = growth_m_s != nullptr ? growth_m_s->at(i, j, k) : 0.0F;
                source_.at(i, j, k) = growth - divergence(velocity, i, j, k);
            }
        }
    });
    solver_.set_matrix(matrix_, rows_, pool);
    const liquid::SolveResult result = solver_.solve(source_, pressure_, limits, pool);
    liquid::for_slices(pool, 0, shape.nz, [&](int k) {
        for (const int axis : liquid::kAxes)
            for (int j = 0; j < shape.ny; ++j)
                subtract_gradient(axis, j, k, velocity);
    });
    return result;
}

void FreeSurface::subtract_gradient(int axis, int j, int k, liquid::VelocityField& velocity) const {
    const grid::BoxShape& shape = domain_->shape();
    const RowRange row = near_rows_.at(j, k);
    const std::ptrdiff_t step = liquid::stride(shape, axis);
    const float *open = domain_->walls().open().along(axis).row(j, k), *liquid = liquid_.row(j, k),
                *level = level_m_.row(j, k), *p = pressure_.row(j, k);
    float* u = velocity.along(axis).row(j, k);
    for (int i = row.begin; i < row.end; ++i) {
        const bool before = liquid[i - step] > 0.0F, behind = liquid[i] > 0.0F;
        if (!(before || behind)) continue;
        if (!(open[i] > 0.0F))
            u[i] = 0.0F;
        else if (before && behind)
            u[i] -= p[i] - p[i - step];
        else if (behind)
            u[i] -= p[i] / theta(level[i], level[i - step]);
        else
            u[i] += p[i - step] / theta(level[i - step], level[i]);
    }
}

}  // namespace pastoso::tank
