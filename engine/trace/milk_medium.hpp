// Milk in the liquid as a scattering medium: its volume fraction between the cells' centres, and what
// light meets on the way through it.
#pragma once

#include "grid/block_field.hpp"
#include "trace/sampler.hpp"

#include <cstdint>
#include <vector>

#include <glm/vec3.hpp>

namespace pastoso::trace {

class MilkMedium {
  public:
    MilkMedium() = default;
    /// `fraction` is trilinear between the centres of its cells, and beyond them that of the nearest;
    /// `scattering_per_m` is what a volume fraction of 1 scatters. Kept is the scattering of each cell,
    /// in 255 steps from the least to the most of its block.
    MilkMedium(const grid::BlockField& fraction, float scattering_per_m);

    bool empty() const { return cells_.empty(); }
    /// Of the field's box, which begins at the origin.
    glm::vec3 size_m() const { return cell_m_ * glm::vec3(shape_cells_); }
    float scattering_per_m() const { return scattering_per_m_; }

    /// How far light gets before it is scattered, at most `limit_m`. By delta tracking (Woodcock et al.
    /// 1965) between a least and a most scattering of each block of cells: below the least the milk
    /// itself need not be asked (Kutz et al. 2017). There is milk up to a cell beyond the field, and no
    /// farther.
    float free_path(const glm::vec3& origin_m, const glm::vec3& direction, float limit_m,
                    Sampler& sampler) const;

    /// An estimate of the share of light that is not scattered within `length_m`, whose mean is true:
    /// the exponential of each block's least scattering, times what residual ratio tracking (Novák et
    /// al. 2014) finds of the rest. What is all but dark is ended by chance.
    float transmittance(const glm::vec3& origin_m, const glm::vec3& direction, float length_m,
                        Sampler& sampler) const;

  private:
    /// Of the scattering within a block, which reaches from the middles of its first cells to those of
    /// the next one's.
    struct Bounds {
        float least_per_m, most_per_m;
    };
    struct Walk;
    int index(const glm::ivec3& block) const {
        return block.x + blocks_.x * (block.y + blocks_.y * block.z);
    }
    void add_block(const grid::BlockField& fraction, const glm::ivec3& block);
    float scattering_near(const glm::vec3& point_m, Sampler& sampler) const;

    glm::ivec3 shape_cells_{0}, blocks_{0};
    float cell_m_ = 0.0F, per_cell_ = 0.0F, scattering_per_m_ = 0.0F;
    std::vector<Bounds> bounds_;       ///< of each block
    std::vector<std::int32_t> slots_;  ///< of each block: where its cells begin; -1: all are 0
    std::vector<std::uint8_t> cells_;
};

}  // namespace pastoso::trace
