#include "film/state.hpp"

#include <cmath>
#include <limits>

#include <gtest/gtest.h>

namespace {

using namespace pastoso::film;  // NOLINT(google-build-using-namespace)

constexpr pastoso::grid::Shape kShape{100, 70};

TEST(FilmState, QuantaAreExactPowersOfTwo) {
    EXPECT_EQ(thickness_mm(1 << 25), 1.0F);
    EXPECT_EQ(optical_thickness(1 << 17), 1.0F);
    EXPECT_LT(kMaxThickness_mm / kThicknessQuantum_mm, std::numeric_limits<std::int32_t>::max());
}

TEST(FilmState, TotalsAreTheSumsOfTheCells) {
    FilmState state(kShape, 0.25);
    state.thickness.set(0, 0, 5);
    state.thickness.set(99, 69, 7);
    state.paint.set(64, 64, {1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12});
    state.paint.set(0, 0, {1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1});
    const Totals sums = totals(state);
    EXPECT_EQ(sums.thickness, 12);
    EXPECT_EQ(sums.paint[0], 2);
    EXPECT_EQ(sums.paint[5], 6);
    EXPECT_EQ(sums.paint[11], 13);
}

TEST(FilmState, TotalsDoNotOverflowAtTheFullestCells) {
    FilmState state(kShape, 0.25);
    constexpr std::int32_t kFull = std::numeric_limits<std::int32_t>::max();
    PaintCell full;
    full.fill(kFull);
    for (int y = 0; y < kShape.height; ++y) {
        for (int x = 0; x < kShape.width; ++x) {
            state.thickness.set(x, y, kFull);
            state.paint.set(x, y, full);
        }
    }
    const std::int64_t expected = std::int64_t{kFull} * kShape.width * kShape.height;
    EXPECT_EQ(totals(state).thickness, expected);
    EXPECT_EQ(totals(state).paint[7], expected);
}

TEST(FilmState, WhatLiesBeyondTheCanvasDoesNotCount) {
    FilmState state(kShape, 0.25);
    const std::uint64_t hash = state_hash(state);
    state.thickness.write(3)[pastoso::grid::Shape::cell_in_tile(100, 64)] = 1 << 25;
    EXPECT_EQ(totals(state).thickness, 0);
    EXPECT_EQ(wet_cell_count(state), 0);
    EXPECT_EQ(state_hash(state), hash);
}

TEST(FilmState, VolumeIsThicknessTimesArea) {
    // 2^25 quanta are 1 mm over a cell of 0.5 mm x 0.5 mm.
    EXPECT_EQ(volume_mm3(std::int64_t{1} << 25, 0.5), 0.25);
}

TEST(FilmState, ACellIsWetAboveATenThousandthOfItsSize) {
    FilmState state(kShape, 0.25);
    const auto trace = static_cast<std::int32_t>(std::floor(0.25e-4 / kThicknessQuantum_mm));
    state.thickness.set(3, 3, trace);
    EXPECT_EQ(wet_cell_count(state), 0);
    state.thickness.set(3, 3, trace + 1);
    state.thickness.set(99, 69, 1 << 20);
    EXPECT_EQ(wet_cell_count(state), 2);
}

TEST(StateHash, DependsOnValuesNotOnHowTheyAreStored) {
    const FilmState dry(kShape, 0.25);
    FilmState written(kShape, 0.25);
    written.thickness.set(3, 3, 1);
    written.thickness.set(3, 3, 0);
    EXPECT_FALSE(written.thickness.is_background(0));
    EXPECT_EQ(state_hash(written), state_hash(dry));
}

TEST(StateHash, EveryFieldCounts) {
    const std::uint64_t dry = state_hash(FilmState(kShape, 0.25));
    EXPECT_NE(state_hash(FilmState(kShape, 0.5)), dry);
    EXPECT_NE(state_hash(FilmState({70, 100}, 0.25)), dry);

    FilmState state(kShape, 0.25);
    state.thickness.set(99, 69, 1);
    EXPECT_NE(state_hash(state), dry);
    state = FilmState(kShape, 0.25);
    state.paint.set(99, 69, {0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1});
    EXPECT_NE(state_hash(state), dry);
    state = FilmState(kShape, 0.25);
    state.velocity_x.set(99, 69, 1e-6F);
    EXPECT_NE(state_hash(state), dry);
    state = FilmState(kShape, 0.25);
    state.velocity_y.set(99, 69, 1e-6F);
    EXPECT_NE(state_hash(state), dry);
    state = FilmState(kShape, 0.25);
    state.support_mm.set(99, 69, 1e-6F);
    EXPECT_NE(state_hash(state), dry);
}

}  // namespace
