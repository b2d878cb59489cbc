#include "tank/tank_frame.hpp"

#include "liquid/flow/sampling.hpp"
#include "liquid/flow/slices.hpp"
#include "tank/sample_rows.hpp"

#include <algorithm>
#include <utility>
#include <vector>

#include <glm/common.hpp>

namespace pastoso::tank {

using liquid::RowRange;

namespace {

/// The surface is smoothed over so many cells (standard deviation): twice as far as particles lie apart.
constexpr float kSmoothing_cells = 0.7F;
/// But nowhere does it lose more than that: drops and thin sheets stay.
constexpr float kMostLost_cells = 0.12F;
/// Rings of cells beside the liquid that take its milk, as far as values between cells look.
constexpr int kMilkRings = 2;

/// 1 2 1 along an axis; what lies beyond the ends is like them.
void blur(const liquid::SampledField& from, int axis, liquid::SampledField& to, core::ThreadPool& pool) {
    const auto [nx, ny, nz, spacing_m, origin_m] = from.lattice();
    liquid::for_slices(pool, 0, nz, [&, nx = nx, ny = ny, nz = nz](int k) {
        for (int j = 0; j < ny; ++j) {
            const float *row = from.row(j, k), *before = row, *after = row;
            float* out = to.row(j, k);
            if (axis == 1) before = from.row(std::max(j - 1, 0), k);
            if (axis == 1) after = from.row(std::min(j + 1, ny - 1), k);
            if (axis == 2) before = from.row(j, std::max(k - 1, 0));
            if (axis == 2) after = from.row(j, std::min(k + 1, nz - 1));
            for (int i = 0; i < nx; ++i) {
                const float low = axis == 0 ? row[std::max(i - 1, 0)] : before[i];
                const float high = axis == 0 ? row[std::min(i + 1, nx - 1)] : after[i];
                out[i] = 0.5F * row[i] + 0.25F * (low + high);
            }
        }
    });
}

/// Particles' bumps are evened out. Within the liquid its distance goes no farther than to -depth;
/// outside it is taken to go no farther either, so that even surfaces stay where they are.
void smooth(float cell_m, float depth_m, liquid::SampledField& level_m, core::ThreadPool& pool) {
    const liquid::Lattice lattice = level_m.lattice();
    // Each pass has a variance of half a spacing squared.
    const float parts = cell_m / lattice.spacing_m;
    const int passes =
        static_cast<int>(2.0F * kSmoothing_cells * kSmoothing_cells * parts * parts + 0.5F);
    liquid::SampledField smoothed(lattice), other(lattice);
    const auto for_rows = [&](const auto& body) {
        liquid::for_slices(pool, 0, lattice.nz, [&](int k) {
            for (int j = 0; j < lattice.ny; ++j)
                body(level_m.row(j, k), smoothed.row(j, k));
        });
    };
    for_rows([&](const float* level, float* out) {
        for (int i = 0; i < lattice.nx; ++i)
            out[i] = std::clamp(level[i], -depth_m, depth_m);
    });
    for (int pass = 0; pass < passes; ++pass)
        for (const int axis : liquid::kAxes) {
            blur(smoothed, axis, other, pool);
            std::swap(smoothed, other);
        }
    const float lost_m = kMostLost_cells * cell_m;
    for_rows([&](float* level, const float* even) {
        for (int i = 0; i < lattice.nx; ++i)
            if (level[i] < depth_m || even[i] < depth_m) level[i] = std::min(even[i], level[i] + lost_m);
    });
}

/// Cells without particles take the mean of their neighbours that have some, ring by ring.
void continue_milk(std::vector<unsigned char>& known, grid::BoxField& milk, core::ThreadPool& pool) {
    const grid::BoxShape& shape = milk.shape();
    const std::ptrdiff_t y = shape.stride_y(), z = shape.stride_z();
    for (int ring = 0; ring < kMilkRings; ++ring) {
        std::vector<unsigned char> next = known;
        liquid::for_slices(pool, 0, shape.nz, [&](int k) {
            for (int j = 0; j < shape.ny; ++j)
                for (int i = 0; i < shape.nx; ++i) {
                    const std::ptrdiff_t at = shape.index(i, j, k);
                    if (known[static_cast<std::size_t>(at)] != 0) continue;
                    float sum = 0.0F;
                    int count = 0;
                    for (const std::ptrdiff_t line :
                         {-y - z, -z, y - z, -y, std::ptrdiff_t{0}, y, z - y, z, y + z})
                        for (std::ptrdiff_t beside = at + line - 1; beside <= at + line + 1; ++beside)
                            if (known[static_cast<std::size_t>(beside)] != 0) {
                                sum += milk.values()[static_cast<std::size_t>(beside)];
                                ++count;
                            }
                    if (count == 0) continue;
                    milk.at(i, j, k) = sum / static_cast<float>(count);
                    next[static_cast<std::size_t>(at)] = 1;
                }
        });
        known = std::move(next);
    }
}

}  // namespace

liquid::Lattice frame_lattice(const grid::BoxShape& shape, int parts) {
    const float spacing_m = shape.cell_m / static_cast<float>(parts);
    return {parts * (shape.nx + 2), parts * (shape.ny + 2), parts * (shape.nz + 2), spacing_m,
            glm::vec3(0.5F * spacing_m - shape.cell_m)};
}

void sample_particles(const ParticleCells& cells, const Domain& domain, liquid::SampledField& level_m,
                      core::ThreadPool& pool) {
    const grid::BoxShape& shape = domain.shape();
    const liquid::Lattice& lattice = level_m.lattice();
    const liquid::RowRanges near = widened_cells(cells.rows(), shape, 1);
    const float far_m = shape.cell_m * (kFrameReach_cells - particle_radius_cells(kFrameReach_cells));
    liquid::for_slices(pool, 0, lattice.nz, [&](int k) {
        for (int j = 0; j < lattice.ny; ++j)
            for (int i = 0; i < lattice.nx; ++i) {
                const glm::vec3 at_m = domain.mirrored_out(lattice.point_m(i, j, k));
                const glm::ivec3 cell = glm::clamp(glm::ivec3(at_m / shape.cell_m), glm::ivec3(0),
                                                   glm::ivec3(shape.nx, shape.ny, shape.nz) - 1);
                const RowRange row = near.at(cell.y, cell.z);
                const bool is_near = cell.x >= row.begin && cell.x < row.end;
                level_m.at(i, j, k) =
                    is_near ? shape.cell_m * particle_distance_cells(cells, shape, at_m / shape.cell_m,
                                                                     kFrameReach_cells)
                            : far_m;
            }
    });
    smooth(shape.cell_m, shape.cell_m * particle_radius_cells(kFrameReach_cells), level_m, pool);
}

void sample_level(const grid::BoxField& cells_m, const Domain& domain, liquid::SampledField& level_m,
                  core::ThreadPool& pool) {
    const liquid::Lattice& lattice = level_m.lattice();
    liquid::for_slices(pool, 0, lattice.nz, [&](int k) {
        for (int j = 0; j < lattice.ny; ++j)
            for (int i = 0; i < lattice.nx; ++i)
                level_m.at(i, j, k) = liquid::sample(cells_m, liquid::Location::Cell,
                                                     domain.mirrored_out(lattice.point_m(i, j, k)),
                                                     liquid::Interpolation::Cubic);
    });
}

void average_milk(std::span<const Particle> particles, const ParticleCells& cells, grid::BoxField& milk,
                  core::ThreadPool& pool) {
    const grid::BoxShape& shape = milk.shape();
    std::vector<unsigned char> known(shape.sample_count(), 0);
    liquid::for_slices(pool, 0, shape.nz, [&](int k) {
        for (int j = 0; j < shape.ny; ++j)
            for (int i = 0; i < shape.nx; ++i) {
                const std::uint32_t begin = cells.begin(i, j, k), end = cells.end(i, j, k);
                float sum = 0.0F;
                for (std::uint32_t p = begin; p < end; ++p)
                    sum += particles[p].milk;
                milk.at(i, j, k) = begin < end ? sum / static_cast<float>(end - begin) : 0.0F;
                known[static_cast<std::size_t>(shape.index(i, j, k))] = begin < end ? 1 : 0;
            }
    });
    continue_milk(known, milk, pool);
}

}  // namespace pastoso::tank
