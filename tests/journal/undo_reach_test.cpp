#include "journal/undo_reach.hpp"

#include <vector>

#include <gtest/gtest.h>

namespace pastoso::journal {
namespace {

using namespace document;

bool crosses(const std::vector<Action>& actions) {
    UndoReach reach;
    for (const Action& action : actions)
        reach.note(action);
    return reach.crossed();
}

TEST(UndoReach, WhatWasDoneSinceMayBeUndone) {
    EXPECT_FALSE(crosses({PenDown{}, PenUp{}, Undo{}, Redo{}, Undo{}}));
    EXPECT_FALSE(crosses({DryNow{}, SqueezePaint{}, Undo{}, Undo{}, Redo{}, Redo{}}));
    EXPECT_FALSE(crosses({UseMedium{}, PenMove{}, PenUp{}}));
}

TEST(UndoReach, WhatWasDoneBeforeMayNot) {
    EXPECT_TRUE(crosses({Undo{}}));
    EXPECT_TRUE(crosses({PenDown{}, Undo{}, Undo{}}));
    EXPECT_TRUE(crosses({Undo{}, Redo{}, PenDown{}}));
}

TEST(UndoReach, NorMayWhatWasTakenBackBefore) {
    EXPECT_TRUE(crosses({Redo{}}));
    EXPECT_TRUE(crosses({DryNow{}, Undo{}, PenDown{}, Redo{}}));
}

TEST(UndoReach, CleaningABareWellIsNoStepToReturnTo) {
    EXPECT_TRUE(crosses({CleanWell{}, Undo{}}));
}

TEST(UndoReach, SelectionsAreStepsWhereThereIsSomethingToSelect) {
    EXPECT_FALSE(crosses({SelectArea{}, SelectByHeight{}, SelectByWetness{}, Undo{}, Undo{}, Undo{}}));
    EXPECT_FALSE(crosses({SelectPaint{}, SelectSimilarColour{}, Undo{}, Undo{}}));
    EXPECT_TRUE(crosses({InvertSelection{}, SelectAll{}, Undo{}}));
    EXPECT_TRUE(
        crosses({GrowSelection{}, ShrinkSelection{}, BorderSelection{}, FeatherSelection{}, Undo{}}));
}

TEST(UndoReach, ChangesOfLayersAreStepsAndWhichOneIsActiveIsNone) {
    EXPECT_FALSE(crosses({AddLayer{"A"}, SetLayer{1, {}}, MergeDown{2}, Undo{}, Undo{}, Undo{}}));
    EXPECT_TRUE(crosses({SelectLayer{1}, Undo{}}));
    EXPECT_TRUE(crosses({Undo{}, FlattenLayers{}, Redo{}}));
}

}  // namespace
}  // namespace pastoso::journal
