#include "tank/seeding.hpp"

#include "core/random.hpp"
#include "liquid/flow/sampling.hpp"

#include <algorithm>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

namespace pastoso::tank {
namespace {

/// New particles keep so far from solids.
constexpr float kGap_cells = 0.05F;
constexpr std::uint32_t kAxisStream = 0x517eU;

}  // namespace

CellSet::CellSet(const grid::BoxShape& shape, const liquid::SignedDistance& distance_m)
    : shape_(shape),
      inside_(static_cast<std::size_t>(shape.nx) * static_cast<std::size_t>(shape.ny) *
                  static_cast<std::size_t>(shape.nz),
              0) {
    std::size_t at = 0;
    for (int k = 0; k < shape.nz; ++k)
        for (int j = 0; j < shape.ny; ++j)
            for (int i = 0; i < shape.nx; ++i, ++at) {
                if (distance_m((glm::vec3(i, j, k) + 0.5F) * shape.cell_m) >= 0.0F) continue;
                inside_[at] = 1;
                cells_.push_back({i, j, k});
            }
}

void CellSet::order_along(const glm::vec3& direction) {
    std::ranges::stable_sort(
        cells_, {}, [&](const glm::ivec3& cell) { return glm::dot(glm::vec3(cell), direction); });
}

std::size_t CellSet::cell_at(const glm::vec3& point_m) const {
    const glm::ivec3 cell = glm::clamp(glm::ivec3(point_m / shape_.cell_m), glm::ivec3(0),
                                       glm::ivec3(shape_.nx, shape_.ny, shape_.nz) - 1);
    return static_cast<std::size_t>((cell.z * shape_.ny + cell.y) * shape_.nx + cell.x);
}

Octants::Octants(const grid::BoxShape& shape, const std::vector<Particle>& particles)
    : shape_(shape),
      taken_(static_cast<std::size_t>(shape.nx) * static_cast<std::size_t>(shape.ny) *
                 static_cast<std::size_t>(shape.nz),
             0) {
    const glm::ivec3 last = 2 * glm::ivec3(shape.nx, shape.ny, shape.nz) - 1;
    for (const Particle& particle : particles) {
        const glm::ivec3 at =
            glm::clamp(glm::ivec3(particle.position_m * (2.0F / shape.cell_m)), glm::ivec3(0), last);
        take(at / 2, at.x % 2 + 2 * (at.y % 2) + 4 * (at.z % 2));
    }
}

int fill_cell(const glm::ivec3& cell, const Filling& filling, int most, Octants& octants,
              std::vector<Particle>& particles, std::uint32_t& made) {
    const float cell_m = filling.domain.shape().cell_m;
    int filled = 0;
    for (int octant = 0; octant < kParticlesPerCell && filled < most; ++octant) {
        if (octants.is_taken(cell, octant)) continue;
        glm::vec3 at_cells(cell);
        for (const int axis : liquid::kAxes) {
            const auto stream =
                core::scramble(filling.seed) + kAxisStream + static_cast<std::uint32_t>(axis);
            at_cells[axis] +=
                0.5F * (static_cast<float>(octant >> axis & 1) + core::uniform_noise(made, stream));
        }
        ++made;
        const glm::vec3 position_m = at_cells * cell_m;
        if (filling.domain.free_m(position_m) < kGap_cells * cell_m ||
            filling.form_m(position_m) >= 0.0F)
            continue;
        Particle particle = filling.kind;
        particle.position_m = position_m;
        particles.push_back(particle);
        octants.take(cell, octant);
        ++filled;
    }
    return filled;
}

int full_count(const CellSet& cells, const Domain& domain, const liquid::SignedDistance& form_m) {
    const float cell_m = domain.shape().cell_m;
    int count = 0;
    for (const glm::ivec3& cell : cells.cells())
        for (int octant = 0; octant < kParticlesPerCell; ++octant) {
            const glm::vec3 middle_m = (glm::vec3(cell) + 0.25F +
                                        0.5F * glm::vec3(octant & 1, octant >> 1 & 1, octant >> 2 & 1)) *
                                       cell_m;
            if (domain.free_m(middle_m) >= 0.0F && form_m(middle_m) < 0.0F) ++count;
        }
    return count;
}

}  // namespace pastoso::tank
