#include "tank/particle_surface.hpp"

#include "core/check.hpp"
#include "liquid/flow/slices.hpp"

#include <algorithm>
#include <cmath>

#include <glm/common.hpp>

namespace pastoso::tank {
namespace {

using liquid::RowRange;

/// Cells along an axis between two, which a wall may mirror.
struct MirroredCell {
    int cell;
    float sign, offset;  ///< where a place at x is seen: sign x + offset, in cells
};
MirroredCell mirrored(int cell, int count) {
    if (cell < 0) return {-1 - cell, -1.0F, 0.0F};
    if (cell >= count) return {2 * count - 1 - cell, -1.0F, 2.0F * static_cast<float>(count)};
    return {cell, 1.0F, 0.0F};
}

/// The runs around a point: up to five cells along each axis, and those that walls along x mirror.
class Neighbourhood {
  public:
    Neighbourhood(const ParticleCells& cells, const glm::vec3& at_cells)
        : cells_(cells), at_cells_(at_cells) {}

    /// Cells [from, to] of the rows that y and z stand for.
    void add(int from, int to, const MirroredCell& x, const MirroredCell& y, const MirroredCell& z) {
        const std::uint32_t begin = cells_.begin(from, y.cell, z.cell),
                            end = cells_.end(to, y.cell, z.cell);
        if (begin == end) return;
        PASTOSO_CHECK_OP(count_, <, kMostRuns);
        runs_[static_cast<std::size_t>(count_++)] = {
            cells_.places(0).data() + begin,
            cells_.places(1).data() + begin,
            cells_.places(2).data() + begin,
            static_cast<int>(end - begin),
            {x.sign, y.sign, z.sign},
            {x.offset - at_cells_.x, y.offset - at_cells_.y, z.offset - at_cells_.z}};
    }
    NearSums sums(float reach2, const ParticleKernels& kernels) const {
        return kernels.sum_near(runs_.data(), count_, reach2);
    }
    bool empty() const { return count_ == 0; }

  private:
    static constexpr int kMostRuns = 5 * 5 * 3;
    const ParticleCells& cells_;
    glm::vec3 at_cells_;
    std::array<PositionRun, kMostRuns> runs_;
    int count_ = 0;
};

}  // namespace

float particle_distance_cells(const ParticleCells& cells, const grid::BoxShape& shape,
                              const glm::vec3& at_cells, float reach_cells,
                              const ParticleKernels& kernels) {
    const float reach2 = reach_cells * reach_cells, radius = particle_radius_cells(reach_cells);
    Neighbourhood around(cells, at_cells);
    const glm::ivec3 low(glm::floor(at_cells - reach_cells)),
        high(glm::ceil(at_cells + reach_cells) - 1.0F);
    for (int k = low.z; k <= high.z; ++k)
        for (int j = low.y; j <= high.y; ++j) {
            const MirroredCell z = mirrored(k, shape.nz), y = mirrored(j, shape.ny);
            around.add(std::max(low.x, 0), std::min(high.x, shape.nx - 1), {0, 1.0F, 0.0F}, y, z);
            for (int i = low.x; i < 0; ++i)
                around.add(-1 - i, -1 - i, mirrored(i, shape.nx), y, z);
            for (int i = shape.nx; i <= high.x; ++i)
                around.add(2 * shape.nx - 1 - i, 2 * shape.nx - 1 - i, mirrored(i, shape.nx), y, z);
        }
    if (around.empty()) return reach_cells - radius;
    const NearSums sums = around.sums(reach2, kernels);
    if (!(sums.weight > 0.0F)) return reach_cells - radius;
    const float x = sums.place[0], y = sums.place[1], z = sums.place[2];
    const float to_mean = std::sqrt((x * x + y * y) + z * z) / sums.weight;
    return std::min(to_mean, std::sqrt(sums.nearest2)) - radius;
}

ParticleSurface::ParticleSurface(const Domain& domain)
    : shape_(domain.shape()),
      domain_(&domain),
      last_rows_(liquid::RowRanges::whole(shape_, liquid::Location::Cell)),
      filled_(shape_.sample_count(), 1),
      surrounded_(shape_.sample_count(), 0),
      counts_(shape_),
      full_(shape_) {}

void ParticleSurface::forget_last(grid::BoxField& level_m, core::ThreadPool& pool) {
    liquid::for_slices(pool, 0, shape_.nz, [&](int k) {
        for (int j = 0; j < shape_.ny; ++j) {
            const RowRange row = last_rows_.at(j, k);
            unsigned char* filled = filled_.data() + shape_.index(0, j, k);
            const float* domain = domain_->share().row(j, k);
            float* level = level_m.row(j, k);
            for (int i = row.begin; i < row.end; ++i) {
                filled[i] = domain[i] > 0.0F ? 0 : 1;
                counts_.at(i, j, k) = full_.at(i, j, k) = 0.0F;
                level[i] = shape_.cell_m * (kKernelReach_cells - kParticleRadius_cells);
            }
        }
    });
}

void ParticleSurface::compute_surrounded(const ParticleCells& cells, const liquid::RowRanges& rows,
                                         core::ThreadPool& pool) {
    const std::ptrdiff_t y = shape_.stride_y(), z = shape_.stride_z();
    liquid::for_slices(pool, 0, shape_.nz, [&](int k) {
        for (int j = 0; j < shape_.ny; ++j) {
            const RowRange row = cells.rows().at(j, k);
            unsigned char* filled = filled_.data() + shape_.index(0, j, k);
            for (int i = row.begin; i < row.end; ++i)
                if (cells.begin(i, j, k) < cells.end(i, j, k)) filled[i] = 1;
        }
    });
    liquid::for_slices(pool, 0, shape_.nz, [&](int k) {
        for (int j = 0; j < shape_.ny; ++j) {
            const RowRange row = rows.at(j, k);
            const unsigned char* filled = filled_.data() + shape_.index(0, j, k);
            unsigned char* surrounded = surrounded_.data() + shape_.index(0, j, k);
            for (int i = row.begin; i < row.end; ++i) {
                unsigned char all = 1;
                for (const std::ptrdiff_t line :
                     {-y - z, -z, y - z, -y, std::ptrdiff_t{0}, y, z - y, z, y + z})
                    all &= filled[i + line - 1] & filled[i + line] & filled[i + line + 1];
                surrounded[i] = all;
            }
        }
    });
}

void ParticleSurface::compute(const ParticleCells& cells, const liquid::RowRanges& rows,
                              grid::BoxField& level_m, core::ThreadPool& pool) {
    forget_last(level_m, pool);
    last_rows_ = rows;
    compute_surrounded(cells, rows, pool);
    liquid::for_slices(pool, 0, shape_.nz, [&](int k) {
        for (int j = 0; j < shape_.ny; ++j) {
            const RowRange row = rows.at(j, k);
            const unsigned char* surrounded = surrounded_.data() + shape_.index(0, j, k);
            float* level = level_m.row(j, k);
            for (int i = row.begin; i < row.end; ++i)
                level[i] = shape_.cell_m * (surrounded[i] != 0 ? -kParticleRadius_cells
                                                               : distance_cells(cells, i, j, k));
        }
    });
}

float ParticleSurface::distance_cells(const ParticleCells& cells, int i, int j, int k) const {
    glm::vec3 at_cells = glm::vec3(i, j, k) + 0.5F;
    if (domain_->distance_m().at(i, j, k) < 0.0F)
        at_cells = domain_->mirrored_out(at_cells * shape_.cell_m) / shape_.cell_m;
    return particle_distance_cells(cells, shape_, at_cells, kKernelReach_cells);
}

/// What blurred() gives where all cells are full.
constexpr float kPerFullBlur = 1.0F / (64.0F * static_cast<float>(kParticlesPerCell));

void ParticleSurface::compute_excess(const ParticleCells& cells, const liquid::RowRanges& rows,
                                     const grid::BoxField& level_m, grid::BoxField& excess,
                                     core::ThreadPool& pool) {
    liquid::for_slices(pool, 0, shape_.nz, [&](int k) {
        for (int j = 0; j < shape_.ny; ++j) {
            const RowRange row = rows.at(j, k);
            const float *level = level_m.row(j, k), *domain = domain_->share().row(j, k);
            const unsigned char* surrounded = surrounded_.data() + shape_.index(0, j, k);
            float *count = counts_.row(j, k), *full = full_.row(j, k);
            for (int i = row.begin; i < row.end; ++i) {
                const float share =
                    surrounded[i] != 0 ? 1.0F : std::clamp(0.5F - level[i] / shape_.cell_m, 0.0F, 1.0F);
                count[i] = static_cast<float>(cells.end(i, j, k) - cells.begin(i, j, k));
                full[i] = static_cast<float>(kParticlesPerCell) * share * domain[i];
            }
        }
    });
    liquid::for_slices(pool, 0, shape_.nz, [&](int k) {
        for (int j = 0; j < shape_.ny; ++j) {
            const RowRange row = rows.at(j, k);
            const unsigned char* surrounded = surrounded_.data() + shape_.index(0, j, k);
            const float *level = level_m.row(j, k), *domain = domain_->share().row(j, k);
            float* out = excess.row(j, k);
            for (int i = row.begin; i < row.end; ++i) {
                out[i] = 0.0F;
                if (!(domain[i] > 0.0F && level[i] < 0.0F)) continue;
                const float more =
                    (blurred(counts_.row(j, k) + i) - blurred(full_.row(j, k) + i)) * kPerFullBlur;
                out[i] = surrounded[i] != 0 ? more : std::max(more, 0.0F);
            }
        }
    });
}

/// 1 2 1 along each axis: unlike even weights they answer no wave with its opposite. 64 times the mean.
float ParticleSurface::blurred(const float* at) const {
    const std::ptrdiff_t y = shape_.stride_y(), z = shape_.stride_z();
    const auto line = [](const float* x) { return (x[-1] + x[1]) + 2.0F * x[0]; };
    const auto slice = [&](const float* x) { return (line(x - y) + line(x + y)) + 2.0F * line(x); };
    return (slice(at - z) + slice(at + z)) + 2.0F * slice(at);
}

}  // namespace pastoso::tank
