#include "grid/block_field.hpp"

#include "core/random.hpp"

#include <algorithm>

#include <gtest/gtest.h>

namespace pastoso::grid {
namespace {

constexpr BoxShape kShape{21, 9, 17, 0.5F};

/// A few cells hold something.
BoxField sparse_field(float share) {
    BoxField field(kShape);
    std::uint32_t index = 0;
    for (int k = 0; k < kShape.nz; ++k)
        for (int j = 0; j < kShape.ny; ++j)
            for (int i = 0; i < kShape.nx; ++i, ++index)
                if (core::uniform_noise(index, 1) < share)
                    field.at(i, j, k) = core::uniform_noise(index, 2) - 0.5F;
    return field;
}

/// Between the middles of cells, beyond them the nearest one's.
float interpolated(const BoxField& field, const glm::vec3& place_cells) {
    float sum = 0.0F;
    for (int k = 0; k < kShape.nz; ++k)
        for (int j = 0; j < kShape.ny; ++j)
            for (int i = 0; i < kShape.nx; ++i) {
                float weight = 1.0F;
                const glm::ivec3 cell(i, j, k), last(kShape.nx - 1, kShape.ny - 1, kShape.nz - 1);
                for (int axis = 0; axis < 3; ++axis) {
                    const float place =
                        std::clamp(place_cells[axis] - 0.5F, 0.0F, static_cast<float>(last[axis]));
                    weight *= std::max(0.0F, 1.0F - std::abs(place - static_cast<float>(cell[axis])));
                }
                sum += weight * field.at(i, j, k);
            }
    return sum;
}

TEST(BlockField, HasTheCellsOfItsField) {
    for (const float share : {0.0F, 0.002F, 0.3F}) {
        const BoxField field = sparse_field(share);
        const BlockField blocks(field);
        EXPECT_EQ(blocks.empty(), share == 0.0F);
        for (int k = 0; k < kShape.nz; ++k)
            for (int j = 0; j < kShape.ny; ++j)
                for (int i = 0; i < kShape.nx; ++i)
                    ASSERT_EQ(blocks.at(i, j, k), field.at(i, j, k));
        EXPECT_EQ(blocks.dense(), field);
    }
}

TEST(BlockField, InterpolatesAcrossItsBlocks) {
    const BoxField field = sparse_field(0.01F);
    const BlockField blocks(field);
    for (std::uint32_t n = 0; n < 2000; ++n) {
        const auto drawn = [&](std::uint32_t axis) { return core::uniform_noise(n, axis); };
        const glm::vec3 place(23.0F * drawn(5) - 1.0F, 11.0F * drawn(6) - 1.0F, 19.0F * drawn(7) - 1.0F);
        // Sums of the same products in another order.
        ASSERT_NEAR(blocks.between(place), interpolated(field, place), 1e-6F);
    }
}

TEST(BlockField, KeepsNoBlockThatHoldsNothing) {
    BoxField field(kShape);
    field.at(10, 4, 3) = 1.0F;
    const BlockField blocks(field);
    EXPECT_EQ(blocks.samples().size(), static_cast<std::size_t>(BlockField::kSamples));
    field.at(8, 4, 3) = 1.0F;  // the block before keeps it too
    EXPECT_EQ(BlockField(field).samples().size(), 2U * BlockField::kSamples);
}

TEST(BlockField, BordersFollowTheirCells) {
    const BoxField field = sparse_field(0.3F);
    BlockField blocks(kShape, std::vector<char>(3 * 2 * 3, 1));
    for (int k = 0; k < kShape.nz; ++k)
        for (int j = 0; j < kShape.ny; ++j)
            for (int i = 0; i < kShape.nx; ++i)
                blocks.block(blocks.index({i / 8, j / 8, k / 8}))[i % 8 + 9 * (j % 8) + 81 * (k % 8)] =
                    field.at(i, j, k);
    blocks.copy_borders(0, 3);
    const BlockField whole(field);
    for (float x = 0.0F; x < 21.0F; x += 0.7F)
        EXPECT_EQ(blocks.between({x, 8.4F, 8.3F}), whole.between({x, 8.4F, 8.3F}));
}

}  // namespace
}  // namespace pastoso::grid
