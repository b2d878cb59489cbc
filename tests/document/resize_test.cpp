// A canvas that is cut and made larger.
#include "document/error_of.hpp"
#include "document/painting.hpp"
#include "document/painting_state.hpp"
#include "document/player.hpp"
#include "document/recorder.hpp"
#include "document/scenes.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace pastoso::document {
namespace {

using testing::HasSubstr;

constexpr double kRounding = 1e-9;

class Resizing : public testing::Test {
  protected:
    void SetUp() override {
        paint_dry_wave(painting);
        painting.apply(AddLayer{"Above"});
        paint_wave(painting, 1.0, 14.0);
    }
    void expect_balance() const {
        EXPECT_LT(painting.account().volume_error_rel(), kRounding);
        EXPECT_LT(painting.account().pigment_error_rel(), kRounding);
    }
    grid::Shape shape() const { return painting.film().shape; }

    core::ThreadPool pool{2};
    Painting painting{small_canvas(), pool};
};

TEST_F(Resizing, MakingRoomMovesThePaintAndAddsTheSameCloth) {
    const film::FilmState before = painting.snapshot().film;
    const Account account = painting.account();
    painting.apply(ResizeCanvas{-5, -3, 60, 50});
    const film::FilmState after = painting.snapshot().film;
    EXPECT_EQ(after.shape, (grid::Shape{180, 150}));
    for (int y = 0; y < before.shape.height; ++y)
        for (int x = 0; x < before.shape.width; ++x) {
            ASSERT_EQ(after.thickness.at(x + 15, y + 9), before.thickness.at(x, y));
            ASSERT_EQ(after.support_mm.at(x + 15, y + 9), before.support_mm.at(x, y));
            ASSERT_EQ(after.strata.optics.at(x + 15, y + 9), before.strata.optics.at(x, y));
        }
    EXPECT_EQ(painting.account().ledger.volume_mm3, account.ledger.volume_mm3);
    EXPECT_EQ(painting.account().canvas.volume_mm3, account.canvas.volume_mm3);
    expect_balance();
    EXPECT_EQ(painting.settings().width_mm, 60.0);
    EXPECT_EQ(painting.settings().support_x_mm, -5.0);
}

TEST_F(Resizing, ACanvasThatWasMadeBeforeIsTheSame) {
    const ResizeCanvas larger{-5, -3, 60, 50};
    Painting other(painting.state(), pool);
    const auto bare = painting.snapshot().bare;
    const ResizedCanvas made = resized_canvas(larger, bare, pool);
    painting.have_ready(made);
    painting.apply(larger);
    EXPECT_EQ(painting.snapshot().bare, made.after);
    other.apply(larger);
    EXPECT_EQ(state_hash(painting.state()), state_hash(other.state()));
}

TEST_F(Resizing, WhatWasMadeOfAnotherCanvasOrForAnotherSizeIsNotTaken) {
    const ResizeCanvas larger{-5, -3, 60, 50}, smaller{1, 1, 20, 20};
    const ResizedCanvas made = resized_canvas(larger, painting.snapshot().bare, pool);
    painting.have_ready(made);
    painting.apply(smaller);
    EXPECT_EQ(painting.settings().width_mm, 20.0);
    painting.apply(larger);
    EXPECT_NE(painting.snapshot().bare, made.after) << "it was of the canvas before";
    EXPECT_EQ(painting.settings().support_x_mm, -4.0);
}

TEST_F(Resizing, TheClothIsThatOfALargerCanvas) {
    painting.apply(ResizeCanvas{10, 5, 20, 20});
    painting.apply(ResizeCanvas{-10, -5, 100, 80});
    CanvasSettings large = small_canvas();
    large.width_mm = 100;
    large.height_mm = 80;
    const film::FilmState cloth = Painting(large, pool).film();
    const PaintingState state = painting.state();
    for (int y = 0; y < shape().height; ++y)
        for (int x = 0; x < shape().width; ++x)
            ASSERT_EQ(state.value.bare->support_mm.at(x, y), cloth.support_mm.at(x, y))
                << x << ", " << y;
}

TEST_F(Resizing, WhatIsCutOffIsWipedOff) {
    const Account before = painting.account();
    painting.apply(ResizeCanvas{0, 0, 20, 30});
    const Account after = painting.account();
    EXPECT_EQ(shape(), (grid::Shape{60, 90}));
    EXPECT_LT(after.canvas.volume_mm3, 0.7 * before.canvas.volume_mm3);
    EXPECT_LT(after.dried.volume_mm3, 0.7 * before.dried.volume_mm3);
    EXPECT_GT(after.ledger.volume_mm3, before.ledger.volume_mm3);
    expect_balance();
}

TEST_F(Resizing, UndoBringsTheCanvasBackAndPaintFlowsOn) {
    painting.apply(TiltCanvas{70, 90});
    const std::uint64_t before = painting.state_hash();
    painting.apply(ResizeCanvas{-5, 2, 30, 20});
    const std::uint64_t small = painting.state_hash();
    for (int tick = 0; tick < 5; ++tick)
        painting.advance_tick();
    const std::uint64_t flowed = painting.state_hash();
    EXPECT_NE(flowed, small);
    paint_wave(painting, 3.0, 8.0);
    painting.apply(ResizeCanvas{0, 0, 30, 20});
    painting.apply(ResizeCanvas{1, 0, 30, 20});
    for (int step = 0; step < 4; ++step)
        painting.apply(Undo{});
    EXPECT_EQ(painting.state_hash(), before);
    EXPECT_EQ(painting.settings(), small_canvas());
    for (int tick = 0; tick < 5; ++tick)
        painting.advance_tick();
    EXPECT_NE(painting.state_hash(), before);
    expect_balance();
    painting.apply(Redo{});
    EXPECT_EQ(painting.state_hash(), flowed);
    EXPECT_EQ(painting.settings().support_x_mm, -5.0);
    expect_balance();
}

TEST_F(Resizing, TheSelectionComesAlong) {
    painting.apply(SelectArea{{{10, 5}, {30, 5}, {30, 20}, {10, 20}}});
    painting.apply(ResizeCanvas{5, 5, 20, 20});
    EXPECT_EQ(grid::chosen_area(*painting.state().value.selection), (grid::Rect{15, 0, 60, 45}));
    painting.apply(ResizeCanvas{0, 16, 20, 4});
    EXPECT_EQ(painting.state().value.selection, nullptr);
}

TEST_F(Resizing, AnImageGoesOnBeyondItsEdges) {
    CanvasSettings settings = small_canvas();
    settings.support = "image";
    film::SupportHeights heights({120, 90});
    for (int y = 0; y < 90; ++y)
        for (int x = 0; x < 120; ++x)
            heights.set(x, y, static_cast<float>(x) / 1024.0F);
    Painting other(settings, heights, pool);
    other.apply(ResizeCanvas{-10, 0, 60, 30});
    EXPECT_EQ(other.film().support_mm.at(0, 40), 0.0F);
    EXPECT_EQ(other.film().support_mm.at(31, 40), 1.0F / 1024.0F);
    EXPECT_EQ(other.film().support_mm.at(179, 89), 119.0F / 1024.0F);
    EXPECT_EQ(other.settings().support_x_mm, -10.0);
}

TEST_F(Resizing, ARecordingReplaysToTheSameBits) {
    Recording recording = crossing_session();
    recording.events.push_back({44, ResizeCanvas{-4, 3, 50, 28}});
    recording.events.push_back({45, PenDown{wave_sample(1.0, 9.0, 0)}});
    recording.events.push_back({50, PenMove{wave_sample(1.0, 9.0, 9)}});
    recording.events.push_back({51, PenUp{}});
    recording.end_tick = 80;
    const auto hash_on = [&](int threads) {
        core::ThreadPool other(threads);
        Painting again(recording.canvas, other);
        Player player(again, recording);
        while (!player.finished())
            player.play_tick();
        return again.state_hash();
    };
    EXPECT_EQ(hash_on(1), hash_on(3));
}

TEST_F(Resizing, WhatCannotBeIsRefused) {
    const std::uint64_t before = painting.state_hash();
    const auto error = [&](const ResizeCanvas& resize) {
        return error_of([&] { painting.apply(resize); });
    };
    EXPECT_THAT(error({0, 0, 0, 30}), HasSubstr("width of the new canvas in mm is 0"));
    EXPECT_THAT(error({1e9, 0, 10, 30}), HasSubstr("x of the new canvas"));
    EXPECT_EQ(painting.state_hash(), before);
    EXPECT_EQ(painting.settings(), small_canvas());
}

}  // namespace
}  // namespace pastoso::document
