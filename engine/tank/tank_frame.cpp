#include "tank/tank_frame.hpp"

#include "liquid/sampling.hpp"
#include "liquid/slices.hpp"
#include "tank/sample_rows.hpp"

#include <glm/common.hpp>

namespace pastoso::tank {

using liquid::RowRange;

liquid::Lattice frame_lattice(const grid::BoxShape& shape, int parts) {
    const float spacing_m = shape.cell_m / static_cast<float>(parts);
    return {parts * (shape.nx + 2), parts * (shape.ny + 2), parts * (shape.nz + 2), spacing_m,
            glm::vec3(0.5F * spacing_m - shape.cell_m)};
}

void sample_particles(const ParticleCells& cells, const Room& room, liquid::SampledField& level_m,
                      core::ThreadPool& pool) {
    const grid::BoxShape& shape = room.shape();
    const liquid::Lattice& lattice = level_m.lattice();
    const liquid::RowRanges near = widened_cells(cells.rows(), shape, 1);
    const float far_m = shape.cell_m * (kFrameReach_cells - particle_radius_cells(kFrameReach_cells));
    liquid::for_slices(pool, 0, lattice.nz, [&](int k) {
        for (int j = 0; j < lattice.ny; ++j)
            for (int i = 0; i < lattice.nx; ++i) {
                const glm::vec3 at_m = room.mirrored_out(lattice.point_m(i, j, k));
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
}

void sample_level(const grid::BoxField& cells_m, const Room& room, liquid::SampledField& level_m,
                  core::ThreadPool& pool) {
    const liquid::Lattice& lattice = level_m.lattice();
    liquid::for_slices(pool, 0, lattice.nz, [&](int k) {
        for (int j = 0; j < lattice.ny; ++j)
            for (int i = 0; i < lattice.nx; ++i)
                level_m.at(i, j, k) = liquid::sample(cells_m, liquid::Location::Cell,
                                                     room.mirrored_out(lattice.point_m(i, j, k)),
                                                     liquid::Interpolation::Cubic);
    });
}

void average_milk(std::span<const Particle> particles, const ParticleCells& cells, grid::BoxField& milk,
                  core::ThreadPool& pool) {
    const grid::BoxShape& shape = milk.shape();
    liquid::for_slices(pool, 0, shape.nz, [&](int k) {
        for (int j = 0; j < shape.ny; ++j)
            for (int i = 0; i < shape.nx; ++i) {
                const std::uint32_t begin = cells.begin(i, j, k), end = cells.end(i, j, k);
                float sum = 0.0F;
                for (std::uint32_t p = begin; p < end; ++p)
                    sum += particles[p].milk;
                milk.at(i, j, k) = begin < end ? sum / static_cast<float>(end - begin) : 0.0F;
            }
    });
}

}  // namespace pastoso::tank
