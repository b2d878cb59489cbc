#include "tank/transfer.hpp"

#include "liquid/flow/slices.hpp"
#include "tank/sample_rows.hpp"

#include <algorithm>

namespace pastoso::tank {
namespace {

using liquid::kAxes;
using liquid::RowRange;

/// So many slices of particles are scattered together. What they write reaches one slice further on
/// either side, so that every other block can be worked on at the same time.
constexpr int kBlockSlices = 4;
/// Where particles weigh less than this, their mean is rounding.
constexpr float kLeastWeight = 1e-6F;

FacePairs face_pairs(const grid::BoxShape& shape, std::array<liquid::AlignedFloats, 3>& pairs) {
    const std::ptrdiff_t origin = 2 * shape.index(0, 0, 0);
    return {{pairs[0].data() + origin, pairs[1].data() + origin, pairs[2].data() + origin},
            shape.stride_y(),
            shape.stride_z(),
            {static_cast<float>(shape.nx), static_cast<float>(shape.ny), static_cast<float>(shape.nz)},
            shape.cell_m};
}

}  // namespace

static_assert(sizeof(Particle) == 7 * sizeof(float));  // as the kernels expect it

Transfer::Transfer(const grid::BoxShape& shape, const ParticleKernels& kernels)
    : shape_(shape), kernels_(&kernels), used_(shape) {
    for (auto& pairs : pairs_)
        pairs.assign(2 * shape.sample_count(), 0.0F);
}

void Transfer::clear(core::ThreadPool& pool) {
    liquid::for_slices(pool, 0, shape_.nz + 1, [&](int k) {
        for (int j = 0; j <= shape_.ny; ++j) {
            const RowRange row = used_.at(j, k);
            if (row.empty()) continue;
            for (auto& pairs : pairs_)
                std::fill_n(pairs.begin() + 2 * shape_.index(row.begin, j, k), 2 * (row.end - row.begin),
                            0.0F);
        }
    });
}

void Transfer::to_faces(const std::vector<Particle>& particles, const ParticleCells& cells,
                        const liquid::RowRanges& samples, liquid::VelocityField& velocity,
                        liquid::VelocityField& weight, core::ThreadPool& pool) {
    clear(pool);
    const int blocks = (shape_.nz + kBlockSlices - 1) / kBlockSlices;
    for (const int first : {0, 1})
        pool.run(static_cast<std::size_t>((blocks - first + 1) / 2), [&](std::size_t n, int) {
            scatter_slices(particles, cells, first + 2 * static_cast<int>(n));
        });
    used_ = samples;
    liquid::for_slices(pool, 0, shape_.nz + 1, [&](int k) {
        for (int j = 0; j <= shape_.ny; ++j) {
            const RowRange row = samples.at(j, k);
            if (row.empty()) continue;
            for (const int axis : kAxes) {
                const float* pairs =
                    pairs_[static_cast<std::size_t>(axis)].data() + 2 * shape_.index(0, j, k);
                float *u = velocity.along(axis).row(j, k), *w = weight.along(axis).row(j, k);
                for (int i = row.begin; i < row.end; ++i) {
                    const float momentum = pairs[2 * i], sum = pairs[2 * i + 1];
                    u[i] = sum > kLeastWeight ? momentum / sum : 0.0F;
                    w[i] = sum > kLeastWeight ? sum : 0.0F;
                }
            }
        }
    });
}

void Transfer::scatter_slices(const std::vector<Particle>& particles, const ParticleCells& cells,
                              int block) {
    const std::uint32_t begin = cells.slice_begin(block * kBlockSlices),
                        end = cells.slice_begin(std::min((block + 1) * kBlockSlices, shape_.nz));
    kernels_->scatter(face_pairs(shape_, pairs_), particles.data() + begin, end - begin);
}

float Transfer::to_particles(const liquid::VelocityField& old, const liquid::VelocityField& now,
                             const liquid::RowRanges& samples, const Following& how,
                             std::vector<Particle>& particles, core::ThreadPool& pool) {
    // Whatever else the pairs hold nobody reads: particles are within these samples.
    used_ = united(used_, samples, shape_);
    liquid::for_slices(pool, 0, shape_.nz + 1, [&](int k) {
        for (int j = 0; j <= shape_.ny; ++j) {
            const RowRange row = samples.at(j, k);
            if (row.empty()) continue;
            for (const int axis : kAxes) {
                float* pairs = pairs_[static_cast<std::size_t>(axis)].data() + 2 * shape_.index(0, j, k);
                const float *before = old.along(axis).row(j, k), *after = now.along(axis).row(j, k);
                for (int i = row.begin; i < row.end; ++i) {
                    pairs[2 * i] = after[i];
                    pairs[2 * i + 1] = before[i];
                }
            }
        }
    });
    const FacePairs pairs = face_pairs(shape_, pairs_);
    constexpr std::size_t kRun = 1024;
    std::vector<float> fastest((particles.size() + kRun - 1) / kRun);
    pool.run(fastest.size(), [&](std::size_t run, int) {
        const std::size_t begin = run * kRun, end = std::min(particles.size(), begin + kRun);
        fastest[run] = kernels_->follow(pairs, how, particles.data() + begin, end - begin);
    });
    return fastest.empty() ? 0.0F : *std::ranges::max_element(fastest);
}

}  // namespace pastoso::tank
