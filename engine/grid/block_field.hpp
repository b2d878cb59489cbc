// Values in a box of cubic cells most of which hold nothing: blocks of 8 x 8 x 8 cells are kept where
// there is something, and all else is 0.
#pragma once

#include "grid/box_field.hpp"

#include <cstdint>
#include <vector>

#include <glm/vec3.hpp>

namespace pastoso::grid {

class BlockField {
  public:
    static constexpr int kSide = 8;  ///< cells along a block
    /// A block keeps the first cells of the next ones too: one is enough to interpolate in.
    static constexpr int kRow = kSide + 1;
    static constexpr int kLayer = kRow * kRow, kSamples = kRow * kLayer;

    /// Which sample of a block its cell (x, y, z) is; kSide stands for the next block's first.
    static constexpr int sample(int x, int y, int z) { return x + kRow * y + kLayer * z; }
    /// Along each axis, of a box.
    static glm::ivec3 block_counts(const BoxShape& shape) {
        return (glm::ivec3(shape.nx, shape.ny, shape.nz) + (kSide - 1)) / kSide;
    }

    BlockField() = default;
    /// All 0. `holds` says of each block, x first, whether it is kept: those with something in them, or
    /// in the cells next to them that they keep.
    BlockField(const BoxShape& shape, const std::vector<char>& holds);
    /// The cells of a field, without its ghosts.
    explicit BlockField(const BoxField& field);

    const BoxShape& shape() const { return shape_; }
    const glm::ivec3& blocks() const { return blocks_; }
    bool empty() const { return samples_.empty(); }

    /// Of a block, x first.
    int index(const glm::ivec3& block) const {
        return block.x + blocks_.x * (block.y + blocks_.y * block.z);
    }
    /// Its samples; null: nothing is kept.
    const float* block(int index) const;
    float* block(int index);

    /// All that is kept.
    std::vector<float>& samples() { return samples_; }
    const std::vector<float>& samples() const { return samples_; }

    float at(int i, int j, int k) const;

    /// All cells, the ghosts 0.
    BoxField dense() const;

    /// What blocks keep of the next ones, in the block layers k0 <= k < k1, after their cells have
    /// changed.
    void copy_borders(int k0, int k1);

    /// Trilinear between the middles of cells, beyond them the nearest one's.
    float between(const glm::vec3& place_cells) const;

  private:
    void copy_border(const glm::ivec3& block);

    BoxShape shape_;
    glm::ivec3 blocks_{0};
    std::vector<std::int32_t> slots_;  ///< of each block; -1: not kept
    std::vector<float> samples_;
};

}  // namespace pastoso::grid
