#include "grid/tiled_field.hpp"

#include <gtest/gtest.h>

namespace {

using pastoso::grid::Shape;
using pastoso::grid::TileBlock;
using pastoso::grid::TiledField;

constexpr Shape kShape{150, 100};

TEST(TiledField, StartsAsBackgroundAndHoldsNoTiles) {
    const TiledField<int> field(kShape, 7);
    EXPECT_EQ(field.tile_count(), 6);
    EXPECT_EQ(field.at(149, 99), 7);
    EXPECT_EQ(field.allocated_bytes(), 0U);
    for (int tile = 0; tile < field.tile_count(); ++tile)
        EXPECT_TRUE(field.is_background(tile));
}

TEST(TiledField, AWriteTouchesItsCellAndTileAlone) {
    TiledField<int> field(kShape, 7);
    field.set(70, 3, 1);
    EXPECT_EQ(field.at(70, 3), 1);
    EXPECT_EQ(field.at(71, 3), 7);
    EXPECT_EQ(field.at(70, 4), 7);
    EXPECT_FALSE(field.is_background(1));
    EXPECT_TRUE(field.is_background(0));
    EXPECT_EQ(field.allocated_bytes(), 64U * 64U * sizeof(int));
}

TEST(TiledField, ASnapshotKeepsItsValues) {
    TiledField<int> field(kShape);
    field.set(5, 5, 1);
    const TiledField<int> snapshot = field;
    field.set(5, 5, 2);
    field.set(140, 90, 3);
    EXPECT_EQ(snapshot.at(5, 5), 1);
    EXPECT_EQ(snapshot.at(140, 90), 0);
    EXPECT_EQ(field.at(5, 5), 2);
}

TEST(TiledField, ASnapshotMayBeWrittenToo) {
    TiledField<int> field(kShape);
    field.set(5, 5, 1);
    TiledField<int> branch = field;
    branch.set(5, 5, 9);
    EXPECT_EQ(field.at(5, 5), 1);
    EXPECT_EQ(branch.at(5, 5), 9);
}

TEST(TiledField, TilesAreSharedUntilWritten) {
    TiledField<int> field(kShape);
    field.set(5, 5, 1);
    field.set(70, 5, 1);
    const TiledField<int> snapshot = field;
    field.set(5, 5, 2);
    EXPECT_FALSE(field.shares_tile(snapshot, 0));
    EXPECT_TRUE(field.shares_tile(snapshot, 1));
    EXPECT_TRUE(field.shares_tile(snapshot, 2));
}

TEST(TiledField, AnOwnTileIsWrittenInPlace) {
    TiledField<int> field(kShape);
    const int* first = field.write(0);
    EXPECT_EQ(field.write(0), first);
    {
        const TiledField<int> snapshot = field;
        EXPECT_NE(field.write(0), first);
    }
    const int* second = field.write(0);
    EXPECT_EQ(field.write(0), second);
}

TEST(TiledField, ResetGivesTheTileBack) {
    TiledField<int> field(kShape, 4);
    field.set(5, 5, 1);
    field.reset(0);
    EXPECT_TRUE(field.is_background(0));
    EXPECT_EQ(field.at(5, 5), 4);
}

TEST(TiledField, ABlockMayMoveBetweenFields) {
    TiledField<int> field(kShape);
    field.set(5, 5, 1);
    TiledField<int> other(kShape);
    other.replace(0, field.block(0));
    EXPECT_TRUE(other.shares_tile(field, 0));
    other.set(5, 5, 2);
    EXPECT_EQ(field.at(5, 5), 1);
}

TEST(TiledFieldDeathTest, CellsBeyondTheCanvasAreRefused) {
    const TiledField<int> field(kShape);
    EXPECT_DEATH(static_cast<void>(field.at(150, 0)), "contains");
    EXPECT_DEATH(static_cast<void>(field.at(0, -1)), "contains");
}

TEST(TileBlock, KnowsWhetherItIsTheOnlyReference) {
    TileBlock<int> block = TileBlock<int>::filled(3);
    EXPECT_TRUE(block.unique());
    TileBlock<int> copy = block;
    EXPECT_FALSE(block.unique());
    EXPECT_EQ(copy, block);
    copy = TileBlock<int>();
    EXPECT_TRUE(block.unique());
    EXPECT_FALSE(copy.unique());
    EXPECT_FALSE(static_cast<bool>(copy));
}

TEST(TileBlock, AMovedBlockKeepsItsReference) {
    TileBlock<int> block = TileBlock<int>::filled(3);
    const TileBlock<int> moved = std::move(block);
    EXPECT_TRUE(moved.unique());
    EXPECT_EQ(moved.read()[pastoso::grid::kTileCells - 1], 3);
}

}  // namespace
