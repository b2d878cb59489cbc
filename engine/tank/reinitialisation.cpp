#include "tank/reinitialisation.hpp"

#include "core/check.hpp"
#include "liquid/flow/slices.hpp"
#include "tank/level_set.hpp"
#include "tank/zero_set.hpp"

#include <cmath>

#include <glm/geometric.hpp>

namespace pastoso::tank {
namespace {

glm::vec3 middle(int i, int j, int k) {
    return glm::vec3(static_cast<float>(i), static_cast<float>(j), static_cast<float>(k)) + 0.5F;
}

/// How much farther the surface may lie than a straight line between two middles says.
constexpr float kMostBend_cells = 0.25F;

bool in_liquid(float phi) {
    return phi < 0.0F;
}

/// The closest place where the lines from a cell's middle to its six neighbours' cross the surface, if
/// any does; straight between the two.
struct Crossing {
    float share = 2.0F;  ///< of the way to the neighbour; above 1: none
    glm::vec3 way{0.0F};
};
Crossing closest_crossing(const float* here, const grid::BoxShape& shape) {
    Crossing closest;
    for (const int axis : liquid::kAxes)
        for (const int side : {-1, 1}) {
            const float there = here[side * liquid::stride(shape, axis)];
            if (in_liquid(*here) == in_liquid(there)) continue;
            const float share = *here / (*here - there);
            if (share < closest.share) {
                closest.share = share;
                closest.way = glm::vec3(0.0F);
                closest.way[axis] = static_cast<float>(side) * share;
            }
        }
    return closest;
}

}  // namespace

Reinitialisation::Reinitialisation(const grid::BoxShape& shape)
    : shape_(shape),
      slots_(shape.sample_count(), -1),
      slices_(static_cast<std::size_t>(shape.nz)),
      added_(static_cast<std::size_t>(shape.nz)) {}

void Reinitialisation::apply(grid::BoxField& phi, float reach_cells, float kept_within_cells,
                             core::ThreadPool& pool) {
    PASTOSO_CHECK(phi.shape() == shape_);
    PASTOSO_CHECK_OP(reach_cells, >=, 1.0F);
    continue_beyond_walls(phi);
    compute_first_ring(phi, pool);
    // A cell at distance d has a neighbour at d - 1 or less, among the 26.
    const int rings = static_cast<int>(std::ceil(reach_cells));
    for (int ring = 1; ring <= rings; ++ring)
        add_ring(ring, reach_cells, pool);
    look_around(pool);
    seek(phi, reach_cells, pool);
    write(phi, reach_cells, kept_within_cells, pool);
    continue_beyond_walls(phi);
}

void Reinitialisation::compute_first_ring(const grid::BoxField& phi, core::ThreadPool& pool) {
    liquid::for_slices(pool, 0, shape_.nz, [&](int k) {
        Slice& slice = slices_[static_cast<std::size_t>(k)];
        slice.clear();
        for (int j = 0; j < shape_.ny; ++j) {
            const float* row = phi.row(j, k);
            for (int i = 0; i < shape_.nx; ++i) {
                const Crossing crossing = closest_crossing(row + i, shape_);
                if (crossing.share > 1.0F) continue;
                const glm::vec3 here = middle(i, j, k), start = here + crossing.way;
                const Foot foot = find_foot(phi, here, start);
                const float found_cells = glm::length(foot.place_cells - here);
                // The crossing lies on the surface but for the bend of the edge: what is much farther
                // away than it is not the closest point.
                const bool better = foot.found && found_cells < crossing.share + kMostBend_cells;
                slots_[static_cast<std::size_t>(shape_.index(i, j, k))] =
                    static_cast<std::int32_t>(slice.size());
                slice.push_back({static_cast<std::int16_t>(i), static_cast<std::int16_t>(j), 0,
                                 better ? found_cells : crossing.share,
                                 better ? foot.place_cells : start, start});
            }
        }
    });
}

void Reinitialisation::push_neighbours(const Slice& previous, int ring, float reach_cells, int k,
                                       Slice& added) {
    const std::size_t old_count = slices_[static_cast<std::size_t>(k)].size();
    for (const Cell& cell : previous) {
        if (cell.ring != ring - 1 || cell.distance_cells > reach_cells) continue;
        for (int j = std::max(cell.j - 1, 0); j <= std::min(cell.j + 1, shape_.ny - 1); ++j)
            for (int i = std::max(cell.i - 1, 0); i <= std::min(cell.i + 1, shape_.nx - 1); ++i) {
                std::int32_t& slot = slots_[static_cast<std::size_t>(shape_.index(i, j, k))];
                if (slot >= 0) continue;
                slot = static_cast<std::int32_t>(old_count + added.size());
                added.push_back(
                    {static_cast<std::int16_t>(i), static_cast<std::int16_t>(j), ring, 0.0F, {}, {}});
            }
    }
}

glm::vec3 Reinitialisation::closest_of_neighbours(const Cell& cell, int k, int rings) const {
    const glm::vec3 here = middle(cell.i, cell.j, k);
    glm::vec3 closest = cell.foot;
    float least = cell.ring < rings ? glm::dot(closest - here, closest - here) : 1e30F;
    for (int near_k = std::max(k - 1, 0); near_k <= std::min(k + 1, shape_.nz - 1); ++near_k) {
        const Slice& slice = slices_[static_cast<std::size_t>(near_k)];
        for (int j = std::max(cell.j - 1, 0); j <= std::min(cell.j + 1, shape_.ny - 1); ++j) {
            const std::int32_t* slots = slots_.data() + shape_.index(0, j, near_k);
            for (int i = std::max(cell.i - 1, 0); i <= std::min(cell.i + 1, shape_.nx - 1); ++i) {
                if (slots[i] < 0) continue;
                const Cell& near = slice[static_cast<std::size_t>(slots[i])];
                if (near.ring >= rings) continue;
                const glm::vec3 off = near.foot - here;
                const float distance2 = glm::dot(off, off);
                if (distance2 < least) {
                    least = distance2;
                    closest = near.foot;
                }
            }
        }
    }
    return closest;
}

void Reinitialisation::add_ring(int ring, float reach_cells, core::ThreadPool& pool) {
    liquid::for_slices(pool, 0, shape_.nz, [&](int k) {
        Slice& added = added_[static_cast<std::size_t>(k)];
        added.clear();
        for (int near_k = std::max(k - 1, 0); near_k <= std::min(k + 1, shape_.nz - 1); ++near_k)
            push_neighbours(slices_[static_cast<std::size_t>(near_k)], ring, reach_cells, k, added);
    });
    liquid::for_slices(pool, 0, shape_.nz, [&](int k) {
        Slice& slice = slices_[static_cast<std::size_t>(k)];
        const Slice& added = added_[static_cast<std::size_t>(k)];
        slice.insert(slice.end(), added.begin(), added.end());
    });
    liquid::for_slices(pool, 0, shape_.nz, [&](int k) {
        Slice& slice = slices_[static_cast<std::size_t>(k)];
        for (std::size_t n = slice.size() - added_[static_cast<std::size_t>(k)].size(); n < slice.size();
             ++n) {
            Cell& cell = slice[n];
            cell.foot = closest_of_neighbours(cell, k, ring);
            cell.distance_cells = glm::length(cell.foot - middle(cell.i, cell.j, k));
        }
    });
}

void Reinitialisation::look_around(core::ThreadPool& pool) {
    // A cell may have been reached from one side first and be closer to another.
    liquid::for_slices(pool, 0, shape_.nz, [&](int k) {
        for (Cell& cell : slices_[static_cast<std::size_t>(k)])
            if (cell.ring > 0) cell.start = closest_of_neighbours(cell, k, cell.ring + 2);
    });
}

void Reinitialisation::seek(const grid::BoxField& phi, float reach_cells, core::ThreadPool& pool) {
    liquid::for_slices(pool, 0, shape_.nz, [&](int k) {
        for (Cell& cell : slices_[static_cast<std::size_t>(k)]) {
            if (cell.ring == 0) continue;
            const glm::vec3 here = middle(cell.i, cell.j, k);
            cell.distance_cells = glm::length(cell.start - here);
            // The point of the surface between two neighbours' is at most half a cell closer.
            if (cell.distance_cells > reach_cells + 0.5F) continue;
            const Foot foot = find_foot(phi, here, cell.start);
            const float found_cells = glm::length(foot.place_cells - here);
            if (foot.found && found_cells < cell.distance_cells) cell.distance_cells = found_cells;
        }
    });
}

void Reinitialisation::write(grid::BoxField& phi, float reach_cells, float kept_within_cells,
                             core::ThreadPool& pool) {
    const float reach_m = reach_cells * shape_.cell_m, kept_m = kept_within_cells * shape_.cell_m;
    liquid::for_slices(pool, 0, shape_.nz, [&](int k) {
        for (int j = 0; j < shape_.ny; ++j) {
            float* row = phi.row(j, k);
            std::int32_t* slots = slots_.data() + shape_.index(0, j, k);
            for (int i = 0; i < shape_.nx; ++i) {
                const std::int32_t slot = slots[i];
                slots[i] = -1;
                float size_m = reach_m;
                if (slot >= 0) {
                    const Cell& cell =
                        slices_[static_cast<std::size_t>(k)][static_cast<std::size_t>(slot)];
                    size_m = std::min(cell.distance_cells * shape_.cell_m, reach_m);
                    if (cell.ring == 0 && std::abs(std::abs(row[i]) - size_m) < kept_m) continue;
                }
                row[i] = in_liquid(row[i]) ? -size_m : size_m;
            }
        }
    });
}

}  // namespace pastoso::tank
