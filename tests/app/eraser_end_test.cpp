// The tool that the other end of a pen takes, and what it gives back.
#include "tools/eraser_end.hpp"

#include <vector>

#include <gtest/gtest.h>

namespace pastoso::tools {
namespace {

class EraserEndTest : public ::testing::Test {
  protected:
    int brushes_taken() const {
        int taken = 0;
        for (const document::Action& action : actions_)
            taken += std::holds_alternative<document::TakeBrush>(action) ? 1 : 0;
        return taken;
    }

    std::vector<document::Action> actions_;
    Easel easel_{Hand{}, [this](document::Action action) { actions_.push_back(std::move(action)); }};
    EraserEnd end_;
};

TEST_F(EraserEndTest, TakesItsToolAndGivesBackTheOneBefore) {
    brush::Preset own = brush::find_preset("Filbert 14");
    own.name = "My filbert";
    easel_.take_brush(own, 17.0);
    EXPECT_TRUE(end_.turn_over("Eraser 15", easel_));
    EXPECT_EQ(easel_.hand().brush, "Eraser 15");
    EXPECT_EQ(easel_.hand().brush_width_mm, 15.0);
    EXPECT_FALSE(end_.turn_over("Eraser 15", easel_));
    EXPECT_TRUE(end_.turn_back(easel_));
    EXPECT_EQ(preset_in_hand(easel_.hand()), own);
    EXPECT_EQ(easel_.hand().brush_width_mm, 17.0);
    EXPECT_FALSE(end_.turn_back(easel_));
    EXPECT_EQ(brushes_taken(), 1) << "and none by the eraser";
}

TEST_F(EraserEndTest, TheBrushComesBackWithWhatItHeld) {
    easel_.take_brush("Filbert 14", 14.0);
    actions_.clear();
    end_.turn_over("Eraser 15", easel_);
    end_.turn_back(easel_);
    ASSERT_EQ(actions_.size(), 3U);
    EXPECT_EQ(std::get<document::LayBrushAside>(actions_[0]).brush.preset, "Eraser 15");
    EXPECT_TRUE(std::holds_alternative<document::SwapBrushes>(actions_[1]));
    EXPECT_TRUE(std::holds_alternative<document::SwapBrushes>(actions_[2]));
}

TEST_F(EraserEndTest, AChangeOfTheBrushOutlivesTheEraser) {
    easel_.take_brush("Filbert 14", 14.0);
    brush::Preset changed = preset_in_hand(easel_.hand());
    changed.paint.film_mm *= 2.0;
    easel_.change_brush(changed);
    end_.turn_over("Eraser 15", easel_);
    end_.turn_back(easel_);
    EXPECT_EQ(preset_in_hand(easel_.hand()).paint.film_mm, changed.paint.film_mm);
    actions_.clear();
    easel_.press(Pointer{});
    EXPECT_EQ(brushes_taken(), 1);
}

TEST_F(EraserEndTest, OnAnotherCanvasTheBrushComesBackDipped) {
    easel_.take_brush("Filbert 14", 14.0);
    end_.turn_over("Eraser 15", easel_);
    actions_.clear();
    easel_.set_up();
    EXPECT_EQ(std::get<document::LayBrushAside>(actions_.back()).brush.preset, "Filbert 14");
    EXPECT_TRUE(end_.turn_back(easel_));
    EXPECT_EQ(easel_.hand().brush, "Filbert 14");
    actions_.clear();
    easel_.press(Pointer{});
    EXPECT_TRUE(std::holds_alternative<document::TakeBrush>(actions_.front()));
}

TEST_F(EraserEndTest, WhereNoBrushLiesAsideTheToolStays) {
    end_.turn_over("Eraser 15", easel_);
    Hand opened = easel_.hand();
    opened.brush_aside.reset();
    easel_.adopt(opened);
    EXPECT_FALSE(end_.turn_back(easel_));
    EXPECT_EQ(easel_.hand().brush, "Eraser 15");
}

TEST_F(EraserEndTest, AHandThatIsFollowedHoldsTheSame) {
    easel_.take_brush("Filbert 14", 14.0);
    end_.turn_over("Eraser 15", easel_);
    std::vector<document::Event> events;
    for (const document::Action& action : actions_)
        events.push_back({0, action});
    EXPECT_EQ(hand_after({}, events).brush, "Eraser 15");
    events.push_back({1, document::SwapBrushes{}});
    EXPECT_EQ(hand_after({}, events).brush, "Filbert 14");
    EXPECT_EQ(hand_after({}, events).brush_width_mm, 14.0);
}

TEST_F(EraserEndTest, KeepsItsOwnWidth) {
    end_.turn_over("Eraser 15", easel_);
    easel_.set_brush_width(6.0);
    end_.turn_back(easel_);
    EXPECT_EQ(easel_.hand().brush_width_mm, 20.0);
    end_.turn_over("Eraser 15", easel_);
    EXPECT_EQ(easel_.hand().brush_width_mm, 6.0);
    end_.turn_back(easel_);
    end_.turn_over("Rag 35", easel_);
    EXPECT_EQ(easel_.hand().brush_width_mm, 35.0);
}

TEST_F(EraserEndTest, AToolTakenInTheMeantimeStays) {
    end_.turn_over("Eraser 15", easel_);
    easel_.take_brush("Fan 26", 26.0);
    EXPECT_FALSE(end_.turn_back(easel_));
    EXPECT_EQ(easel_.hand().brush, "Fan 26");
    EXPECT_FALSE(end_.in_use());
}

TEST_F(EraserEndTest, MayPaintWithWhatIsInHand) {
    EXPECT_FALSE(end_.turn_over("", easel_));
    EXPECT_FALSE(end_.turn_back(easel_));
    EXPECT_TRUE(actions_.empty());
}

}  // namespace
}  // namespace pastoso::tools
