// Making and taking away particles, an octant of a cell at a time: one particle each is full.
#pragma once

#include "tank/domain.hpp"
#include "tank/particle.hpp"

#include <cstdint>
#include <vector>

namespace pastoso::tank {

/// Some of the cells of a box.
class CellSet {
  public:
    CellSet() = default;
    /// Those whose middles are within a form.
    CellSet(const grid::BoxShape& shape, const liquid::SignedDistance& distance_m);

    bool holds(const glm::vec3& point_m) const { return inside_[cell_at(point_m)] != 0; }
    const std::vector<glm::ivec3>& cells() const { return cells_; }
    /// Puts those first that lie furthest against a direction.
    void order_along(const glm::vec3& direction);

  private:
    std::size_t cell_at(const glm::vec3& point_m) const;

    grid::BoxShape shape_;
    std::vector<std::uint8_t> inside_;
    std::vector<glm::ivec3> cells_;
};

/// Which octants of a box's cells have particles.
class Octants {
  public:
    Octants(const grid::BoxShape& shape, const std::vector<Particle>& particles);

    bool is_taken(const glm::ivec3& cell, int octant) const {
        return (taken_[index(cell)] >> octant & 1) != 0;
    }
    void take(const glm::ivec3& cell, int octant) {
        taken_[index(cell)] = static_cast<std::uint8_t>(taken_[index(cell)] | 1 << octant);
    }

  private:
    std::size_t index(const glm::ivec3& cell) const {
        return static_cast<std::size_t>((cell.z * shape_.ny + cell.y) * shape_.nx + cell.x);
    }
    grid::BoxShape shape_;
    std::vector<std::uint8_t> taken_;
};

/// What fills cells with particles, and where.
struct Filling {
    const Domain& domain;
    const liquid::SignedDistance& form_m;
    Particle kind;
    std::uint32_t seed;
};

/// Puts a particle into every octant of the cell that has none, but `most` at most, at a place that seed
/// and the number of particles made before decide, if that is in the domain and within the form. Returns
/// how many those are.
int fill_cell(const glm::ivec3& cell, const Filling& filling, int most, Octants& octants,
              std::vector<Particle>& particles, std::uint32_t& made);

/// How many particles fill the cells as far as they are in the domain and within a form.
int full_count(const CellSet& cells, const Domain& domain, const liquid::SignedDistance& form_m);

}  // namespace pastoso::tank
