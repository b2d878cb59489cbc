#include "film/support/support_heights.hpp"

#include <array>
#include <cmath>
#include <limits>

#include <gtest/gtest.h>

namespace pastoso::film {
namespace {

using grid::kTileCells;
using grid::TileBlock;

constexpr auto kQuantum_mm = static_cast<float>(kSupportQuantum_mm);

/// Level 3 everywhere, but 65535 in cell 7.
HeightBlock levels_of(float level_mm) {
    auto levels = TileBlock<std::uint16_t>::filled(3);
    levels.write()[7] = 65535;
    return {levels, level_mm};
}

TEST(FinestLevel, ReachesTheHeightWithSixteenBits) {
    EXPECT_EQ(finest_level_mm(0.0), kSupportQuantum_mm);
    EXPECT_EQ(finest_level_mm(65535 * kSupportQuantum_mm), kSupportQuantum_mm);
    EXPECT_EQ(finest_level_mm(65536 * kSupportQuantum_mm), 2 * kSupportQuantum_mm);
    for (const double highest_mm : {0.02, 0.08, 0.11, 1.0, 20.0}) {
        const double level_mm = finest_level_mm(highest_mm);
        EXPECT_LE(highest_mm, 65535 * level_mm);
        EXPECT_EQ(std::log2(level_mm), std::floor(std::log2(level_mm)));
    }
}

TEST(HeightBlock, LevelsAreReadAsMillimetres) {
    const HeightBlock block = levels_of(2 * kQuantum_mm);
    EXPECT_TRUE(block.in_levels());
    EXPECT_EQ(block.read()[0], 6 * kQuantum_mm);
    EXPECT_EQ(block.read()[7], 131070 * kQuantum_mm);
    std::array<float, 3> row{};
    block.read().copy(6, 3, row.data());
    EXPECT_EQ(row, (std::array{6 * kQuantum_mm, 131070 * kQuantum_mm, 6 * kQuantum_mm}));
}

TEST(HeightBlock, TellsTheHighestOfSomeCells) {
    const auto height_of = [](int cell) { return static_cast<float>((cell * 37) % 101) * 0x1p-10F; };
    grid::TileBlock<float> heights = grid::TileBlock<float>::filled(0.0F);
    grid::TileBlock<std::uint16_t> levels = grid::TileBlock<std::uint16_t>::filled(0);
    for (int cell = 0; cell < grid::kTileCells; ++cell) {
        heights.write()[cell] = height_of(cell);
        levels.write()[cell] = static_cast<std::uint16_t>((cell * 37) % 101);
    }
    for (const HeightBlock& block : {HeightBlock(heights), HeightBlock(levels, 0x1p-10F)}) {
        const TileHeights read = block.read();
        EXPECT_EQ(read.highest(70), height_of(70));
        EXPECT_EQ(read.highest(3, 900, 41, 4095),
                  std::max({height_of(3), height_of(900), height_of(41), height_of(4095)}));
    }
}

TEST(HeightBlock, WritingMakesFloatsOfItsOwn) {
    HeightBlock block = levels_of(kQuantum_mm);
    const HeightBlock copy = block;
    block.write()[0] = 0.3F;
    EXPECT_FALSE(block.in_levels());
    EXPECT_EQ(block.read()[0], 0.3F);
    EXPECT_EQ(block.read()[7], 65535 * kQuantum_mm);
    EXPECT_TRUE(copy.in_levels());
    EXPECT_EQ(copy.read()[0], 3 * kQuantum_mm);
    EXPECT_NE(block, copy);
    const HeightBlock floats = block;
    block.write()[0] = 0.4F;
    EXPECT_EQ(floats.read()[0], 0.3F);
}

TEST(HeightBlock, TheSmallestFormHoldsTheSameHeights) {
    for (const float level_mm : {kQuantum_mm, 4 * kQuantum_mm, 0.25F}) {
        const HeightBlock levels = levels_of(level_mm);
        const HeightBlock again = HeightBlock::smallest_of(copied_heights(levels.read()));
        EXPECT_TRUE(again.in_levels());
        for (int cell = 0; cell < kTileCells; ++cell)
            ASSERT_EQ(again.read()[cell], levels.read()[cell]);
    }
}

TEST(HeightBlock, WhatNoLevelsHoldStaysFloats) {
    const float none = std::numeric_limits<float>::quiet_NaN();
    // Between two quanta, below 0, higher than 16 bits of quanta beside a single quantum, no number.
    for (const float odd_mm : {1.5F * kQuantum_mm, -kQuantum_mm, 70001 * kQuantum_mm, 1e9F, none}) {
        auto heights = TileBlock<float>::filled(kQuantum_mm);
        heights.write()[100] = odd_mm;
        const HeightBlock block = HeightBlock::smallest_of(heights);
        EXPECT_FALSE(block.in_levels()) << odd_mm;
        EXPECT_EQ(block.read()[0], kQuantum_mm);
    }
}

TEST(SupportHeights, IsFlatUntilWritten) {
    SupportHeights field({100, 70});
    EXPECT_EQ(field.at(99, 69), 0.0F);
    EXPECT_TRUE(field.is_background(3));
    EXPECT_EQ(field.allocated_bytes(), 0U);
    const SupportHeights before = field;
    field.set(99, 69, 0.5F);
    EXPECT_EQ(field.at(99, 69), 0.5F);
    EXPECT_EQ(before.at(99, 69), 0.0F);
    EXPECT_FALSE(field.is_background(3));
    EXPECT_FALSE(field.shares_tile(before, 3));
    EXPECT_TRUE(field.shares_tile(before, 0));
    field.reset(3);
    EXPECT_TRUE(field.shares_tile(before, 3));
}

TEST(SupportHeights, CountsTheBytesOfBothForms) {
    SupportHeights field({128, 64});
    field.replace(0, levels_of(kQuantum_mm));
    field.set(64, 0, 0.5F);
    EXPECT_EQ(field.allocated_bytes(), (2U + 4U) * kTileCells);
}

}  // namespace
}  // namespace pastoso::film
