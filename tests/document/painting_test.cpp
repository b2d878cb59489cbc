#include "document/painting.hpp"

#include "core/units.hpp"
#include "document/error_of.hpp"
#include "document/scenes.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace pastoso::document {
namespace {

using testing::HasSubstr;

/// Paint is moved in whole quanta and in doubles, so that only their rounding is left.
constexpr double kRounding = 1e-9;

class PaintingTest : public testing::Test {
  protected:
    core::ThreadPool pool{1};
    Painting painting{small_canvas(), pool};

    void take_loaded_brush(const char* pigment = "PB29") {
        painting.apply(TakeBrush{"flat", 8, 1});
        painting.apply(load_of(pigment));
    }
    void advance(int ticks) {
        for (int i = 0; i < ticks; ++i)
            painting.advance_tick();
    }
    void expect_balance() const {
        EXPECT_LT(painting.account().volume_error_rel(), kRounding);
        EXPECT_LT(painting.account().pigment_error_rel(), kRounding);
    }
};

TEST_F(PaintingTest, StartsBareAndFlat) {
    const Account account = painting.account();
    EXPECT_EQ(account.taken.volume_mm3, 0.0);
    EXPECT_EQ(account.canvas.volume_mm3, 0.0);
    EXPECT_EQ(account.volume_error_rel(), 0.0);
    EXPECT_EQ(painting.tick(), 0);
    EXPECT_FALSE(painting.can_undo());
    EXPECT_FALSE(painting.can_redo());
    EXPECT_EQ(painting.film().shape, (grid::Shape{120, 90}));
}

TEST_F(PaintingTest, EveryDropIsAccountedFor) {
    take_loaded_brush();
    expect_balance();
    paint_wave(painting, 0.0, 10.0);
    expect_balance();
    EXPECT_GT(painting.account().canvas.volume_mm3, 0.0);
    painting.apply(CleanBrush{});
    EXPECT_EQ(painting.account().brush.volume_mm3, 0.0);
    EXPECT_GT(painting.account().ledger.volume_mm3, 0.0);
    expect_balance();
    painting.apply(TakeBrush{"knife", 0, 1});
    paint_wave(painting, 1.0, 12.0);
    advance(3);
    expect_balance();
    painting.apply(TakeBrush{"round", 0, 1});
    expect_balance();
}

TEST_F(PaintingTest, ABlottedBrushIsAccountedFor) {
    take_loaded_brush();
    const double held_mm3 = painting.account().brush.volume_mm3;
    const double fill = painting.snapshot().brush_load.fill;
    painting.apply(CleanBrush{0.25});
    EXPECT_NEAR(painting.account().brush.volume_mm3, 0.75 * held_mm3, kRounding * held_mm3);
    EXPECT_NEAR(painting.snapshot().brush_load.fill, 0.75 * fill, kRounding);
    expect_balance();
    EXPECT_THAT(error_of([&] { painting.apply(CleanBrush{1.5}); }), HasSubstr("1.5"));
}

TEST_F(PaintingTest, PaintThatRunsOffTheEdgeIsAccountedFor) {
    painting.apply(UseMedium{"ink glaze"});
    painting.apply(TiltCanvas{90, 90});
    take_loaded_brush();
    for (int i = 0; i < 3; ++i)
        paint_wave(painting, i, 28.0);
    painting.apply(CleanBrush{});
    const double wiped_mm3 = painting.account().ledger.volume_mm3;
    advance(60);
    EXPECT_GT(painting.account().ledger.volume_mm3, wiped_mm3);
    expect_balance();
}

TEST_F(PaintingTest, MediumThinsThePaintAtTheSameVolume) {
    painting.apply(TakeBrush{"flat", 8, 1});
    painting.apply(load_of("PB29"));
    const Account full = painting.account();
    painting.apply(CleanBrush{});
    LoadPaint thinned = load_of("PB29");
    thinned.paint.strength = 0.25;
    painting.apply(thinned);
    const Account::Amount glaze = painting.account().brush;
    EXPECT_NEAR(glaze.volume_mm3, full.brush.volume_mm3, kRounding * full.brush.volume_mm3);
    for (int k = 0; k < pigment::kChannels; ++k) {
        EXPECT_NEAR(glaze.pigment[k], 0.25 * full.brush.pigment[k], kRounding * full.brush.pigment[k]);
    }
}

TEST_F(PaintingTest, APenNeedsABrush) {
    EXPECT_EQ(error_of([&] { painting.apply(PenDown{}); }),
              "the pen touches the canvas with no brush in hand.");
    EXPECT_EQ(error_of([&] { painting.apply(load_of("PB29")); }),
              "there is no brush in hand to take paint with.");
    painting.apply(CleanBrush{});
    painting.apply(PenMove{});
    painting.apply(PenUp{});
    EXPECT_FALSE(painting.stroke_in_progress());
}

TEST_F(PaintingTest, RefusedActionsChangeNothing) {
    take_loaded_brush();
    painting.apply(PenDown{wave_sample(1.0, 10.0, 0)});
    const std::uint64_t hash = painting.state_hash();
    EXPECT_THAT(error_of([&] { painting.apply(TakeBrush{"broom", 0, 1}); }), HasSubstr("broom"));
    EXPECT_THAT(error_of([&] { painting.apply(load_of("XX9")); }), HasSubstr("XX9"));
    EXPECT_THAT(error_of([&] { painting.apply(UseMedium{"honey"}); }), HasSubstr("honey"));
    EXPECT_THAT(error_of([&] { painting.apply(TiltCanvas{-1, 0}); }), HasSubstr("tilt"));
    EXPECT_THAT(error_of([&] { painting.apply(PenMove{wave_sample(0.5, 10.0, 1)}); }),
                HasSubstr("earlier"));
    EXPECT_THAT(error_of([&] { painting.apply(PenMove{{2.0, 1, 1, NAN}}); }), HasSubstr("nan"));
    EXPECT_EQ(painting.state_hash(), hash);
    EXPECT_TRUE(painting.stroke_in_progress());
}

TEST_F(PaintingTest, UndoBringsBackStateAccountAndBrush) {
    take_loaded_brush();
    paint_wave(painting, 0.0, 8.0);
    const std::uint64_t before = painting.state_hash();
    const Account account = painting.account();
    paint_wave(painting, 1.0, 16.0);
    const std::uint64_t after = painting.state_hash();
    EXPECT_NE(after, before);

    painting.apply(Undo{});
    EXPECT_EQ(painting.state_hash(), before);
    EXPECT_EQ(painting.account().brush.volume_mm3, account.brush.volume_mm3);
    expect_balance();
    painting.apply(Redo{});
    EXPECT_EQ(painting.state_hash(), after);
    expect_balance();
    painting.apply(Undo{});
    paint_wave(painting, 1.0, 16.0);
    EXPECT_EQ(painting.state_hash(), after);
    EXPECT_FALSE(painting.can_redo());
}

TEST_F(PaintingTest, UndoKeepsABrushThatWasTakenSince) {
    take_loaded_brush("PB29");
    paint_wave(painting, 0.0, 8.0);
    painting.apply(CleanBrush{});
    painting.apply(load_of("PR254"));
    const Account::Amount red = painting.account().brush;
    painting.apply(Undo{});
    EXPECT_EQ(painting.account().brush.pigment, red.pigment);
    EXPECT_EQ(painting.account().canvas.volume_mm3, 0.0);
    expect_balance();
    painting.apply(Redo{});
    EXPECT_EQ(painting.account().brush.pigment, red.pigment);
    expect_balance();
}

TEST_F(PaintingTest, UndoBringsBackPaintThatRanOff) {
    painting.apply(UseMedium{"ink glaze"});
    painting.apply(TiltCanvas{90, 90});
    take_loaded_brush();
    for (int i = 0; i < 3; ++i)
        paint_wave(painting, i, 28.0);
    advance(30);
    EXPECT_GT(painting.account().ledger.volume_mm3, 0.0);
    for (int i = 0; i < 3; ++i)
        painting.apply(Undo{});
    EXPECT_EQ(painting.account().ledger.volume_mm3, 0.0);
    EXPECT_EQ(painting.account().canvas.volume_mm3, 0.0);
    expect_balance();
}

TEST_F(PaintingTest, UndoInTheMiddleOfAStrokeEndsIt) {
    take_loaded_brush();
    const std::uint64_t before = painting.state_hash();
    painting.apply(PenDown{wave_sample(0.0, 10.0, 0)});
    for (int i = 1; i < 20; ++i)
        painting.apply(PenMove{wave_sample(0.0, 10.0, i)});
    painting.apply(Undo{});
    EXPECT_FALSE(painting.stroke_in_progress());
    EXPECT_EQ(painting.state_hash(), before);
    painting.apply(PenMove{wave_sample(0.0, 10.0, 21)});
    EXPECT_EQ(painting.state_hash(), before);
    expect_balance();
}

TEST_F(PaintingTest, UndoAndRedoWithNothingToReturnToDoNothing) {
    const std::uint64_t hash = painting.state_hash();
    painting.apply(Undo{});
    painting.apply(Redo{});
    EXPECT_EQ(painting.state_hash(), hash);
}

TEST_F(PaintingTest, ThirtyStrokesCanBeUndone) {
    take_loaded_brush();
    std::vector<std::uint64_t> hashes;
    for (int i = 0; i < 30; ++i) {
        hashes.push_back(painting.state_hash());
        paint_wave(painting, i, 5.0 + 0.6 * i);
    }
    for (int i = 29; i >= 0; --i) {
        ASSERT_TRUE(painting.can_undo());
        painting.apply(Undo{});
        EXPECT_EQ(painting.state_hash(), hashes[static_cast<std::size_t>(i)]);
    }
    expect_balance();
}

TEST_F(PaintingTest, ASnapshotIsNotTouchedByWhatComesLater) {
    take_loaded_brush();
    paint_wave(painting, 0.0, 10.0);
    const Snapshot snapshot = painting.snapshot();
    const std::uint64_t hash = film::state_hash(snapshot.film);
    paint_wave(painting, 1.0, 12.0);
    advance(2);
    EXPECT_EQ(film::state_hash(snapshot.film), hash);
    EXPECT_EQ(snapshot.tick, 0);
    EXPECT_EQ(painting.tick(), 2);
}

TEST_F(PaintingTest, TellsWhatItDid) {
    take_loaded_brush();
    paint_wave(painting, 0.0, 10.0);
    painting.advance_tick();
    EXPECT_GT(painting.film_report().steps, 0);
    EXPECT_GT(painting.stage_times().brush_s, 0.0);
    EXPECT_GT(painting.stage_times().film_s, 0.0);
}

TEST(Painting, RefusesUnknownSupportsAndAbsurdSizes) {
    core::ThreadPool pool(1);
    CanvasSettings canvas = small_canvas();
    canvas.support = "paper napkin";
    EXPECT_THAT(error_of([&] { Painting(canvas, pool); }), HasSubstr("paper napkin"));
    canvas = small_canvas();
    canvas.width_mm = canvas.height_mm = 5000;
    canvas.px_per_mm = 6.5;
    EXPECT_THAT(error_of([&] { Painting(canvas, pool); }), HasSubstr("needs about"));
}

}  // namespace
}  // namespace pastoso::document
