// A stroke that is turned after its start is the stroke that had this rotation from the beginning.

#include "core/thread_pool.hpp"
#include "document/painting_state.hpp"
#include "document/scenes.hpp"

#include <gtest/gtest.h>

namespace pastoso::document {
namespace {

constexpr double kTurned_deg = 40.0;

class TurnStrokeTest : public ::testing::Test {
  protected:
    TurnStrokeTest() {
        for (Painting* painting : {&turned_, &straight_}) {
            painting->apply(UseMedium{"fluid acrylic"});
            painting->apply(TakeBrush{"flat", 8, 1});
            painting->apply(load_of("PB29"));
            paint_wave(*painting, 0.0, 8.0);
            painting->apply(CleanBrush{});
            painting->apply(load_of("PW6"));
        }
    }

    static brush::PenSample sample(int i, double rotation_deg) {
        brush::PenSample sample = wave_sample(1.0, 11.0, i);
        sample.rotation_deg = rotation_deg;
        return sample;
    }
    /// Samples [from, to] of a stroke; the first of all comes down.
    static void lay(Painting& painting, int from, int to, double rotation_deg) {
        for (int i = from; i <= to; ++i) {
            if (i == 0)
                painting.apply(PenDown{sample(i, rotation_deg)});
            else
                painting.apply(PenMove{sample(i, rotation_deg)});
        }
    }

    core::ThreadPool pool_{1};
    Painting turned_{small_canvas(), pool_}, straight_{small_canvas(), pool_};
};

TEST_F(TurnStrokeTest, IsTheStrokeThatStoodSoFromTheBeginning) {
    lay(turned_, 0, 5, -30.0);
    turned_.apply(TurnStroke{kTurned_deg});
    lay(turned_, 6, 30, kTurned_deg);
    turned_.apply(PenUp{});
    lay(straight_, 0, 30, kTurned_deg);
    straight_.apply(PenUp{});
    EXPECT_EQ(turned_.state_hash(), straight_.state_hash());
    EXPECT_EQ(turned_.account().brush.volume_mm3, straight_.account().brush.volume_mm3);
}

TEST_F(TurnStrokeTest, ChangesWhatWouldHaveLainAskew) {
    lay(turned_, 0, 30, -30.0);
    turned_.apply(PenUp{});
    lay(straight_, 0, 30, kTurned_deg);
    straight_.apply(PenUp{});
    EXPECT_NE(turned_.state_hash(), straight_.state_hash());
}

TEST_F(TurnStrokeTest, KeepsAllPaintAlsoWhereItRunsMeanwhile) {
    turned_.apply(TiltCanvas{60, 90});
    lay(turned_, 0, 3, -30.0);
    for (int tick = 0; tick < 8; ++tick)
        turned_.advance_tick();
    turned_.apply(TurnStroke{kTurned_deg});
    for (int tick = 0; tick < 8; ++tick)
        turned_.advance_tick();
    lay(turned_, 4, 30, kTurned_deg);
    turned_.apply(PenUp{});
    // Sums of doubles over a few thousand cells.
    EXPECT_LT(turned_.account().volume_error_rel(), 1e-12);
}

TEST_F(TurnStrokeTest, IsOneStepOfUndo) {
    const std::uint64_t before = turned_.state_hash();
    const std::size_t steps = turned_.undo_steps().size();
    lay(turned_, 0, 5, -30.0);
    turned_.apply(TurnStroke{kTurned_deg});
    lay(turned_, 6, 9, kTurned_deg);
    turned_.apply(PenUp{});
    EXPECT_EQ(turned_.undo_steps().size(), steps + 1);
    turned_.apply(Undo{});
    EXPECT_EQ(turned_.state_hash(), before);
}

TEST_F(TurnStrokeTest, NeedsNoHistory) {
    turned_.set_history_budget(0);
    lay(turned_, 0, 5, -30.0);
    turned_.apply(TurnStroke{kTurned_deg});
    lay(turned_, 6, 30, kTurned_deg);
    turned_.apply(PenUp{});
    lay(straight_, 0, 30, kTurned_deg);
    straight_.apply(PenUp{});
    EXPECT_EQ(turned_.state_hash(), straight_.state_hash());
}

TEST_F(TurnStrokeTest, HappensOnceInAStrokeAndNotWithoutOne) {
    const std::uint64_t before = turned_.state_hash();
    turned_.apply(TurnStroke{kTurned_deg});
    EXPECT_EQ(turned_.state_hash(), before);
    lay(turned_, 0, 5, -30.0);
    turned_.apply(TurnStroke{kTurned_deg});
    const std::uint64_t once = turned_.state_hash();
    turned_.apply(TurnStroke{-80.0});
    EXPECT_EQ(turned_.state_hash(), once);
    EXPECT_TRUE(turned_.stroke_in_progress());
}

TEST_F(TurnStrokeTest, WorksInTheMixingWellToo) {
    for (Painting* painting : {&turned_, &straight_})
        painting->apply(SqueezePaint{{{{"PY35", 1.0}}}, 250.0, 12.0, 12.0});
    turned_.apply(PenDown{sample(0, -30.0), Surface::Well});
    lay(turned_, 1, 5, -30.0);
    turned_.apply(TurnStroke{kTurned_deg});
    lay(turned_, 6, 20, kTurned_deg);
    straight_.apply(PenDown{sample(0, kTurned_deg), Surface::Well});
    lay(straight_, 1, 20, kTurned_deg);
    for (Painting* painting : {&turned_, &straight_})
        painting->apply(PenUp{});
    EXPECT_EQ(turned_.state_hash(), straight_.state_hash());
}

TEST(ThinnedMedium, IsPartOfWhatIsInHand) {
    core::ThreadPool pool(1);
    Painting whole(small_canvas(), pool), thin(small_canvas(), pool);
    whole.apply(UseMedium{"heavy-body oil"});
    thin.apply(UseMedium{.name = "heavy-body oil", .paint_share = 0.2});
    for (Painting* painting : {&whole, &thin}) {
        painting->apply(TakeBrush{"flat", 8, 1});
        painting->apply(load_of("PB29"));
        paint_wave(*painting, 0.0, 8.0);
    }
    const Account::Amount strong = whole.account().canvas, weak = thin.account().canvas;
    const double strength = weak.pigment[0] / weak.volume_mm3 / (strong.pigment[0] / strong.volume_mm3);
    // Channels of a cell are rounded to quanta.
    EXPECT_NEAR(strength, 0.2, 1e-4);
    EXPECT_EQ(thin.state().value.medium.paint_share, 0.2);
}

}  // namespace
}  // namespace pastoso::document
