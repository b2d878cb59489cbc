// A canvas that is drawn out, or made of other cells, with all that lies on it.
#include "document/cloth.hpp"
#include "document/error_of.hpp"
#include "document/heights_apart.hpp"
#include "document/painting.hpp"
#include "document/painting_state.hpp"
#include "document/played.hpp"
#include "document/scenes.hpp"
#include "layers/turning.hpp"

#include <cmath>
#include <memory>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace pastoso::document {
namespace {

using testing::HasSubstr;

constexpr double kRounding = 1e-9;
constexpr ScaleCanvas kFiner{1.0, 1.0, 2.0}, kLarger{1.5, 1.5, 1.0};

class CanvasScaling : public testing::Test {
  protected:
    /// Dry paint, wet paint that has run over the edge, paint on the well, and two layers.
    void SetUp() override {
        paint_dry_wave(painting);
        painting.apply(load_of("PY35"));
        paint_wave(painting, 1.0, 27.0);
        painting.apply(AddLayer{"Above"});
        painting.apply(SqueezePaint{{{{"PR108", 1.0}}, 1.0}, 50.0, 30.0, 30.0});
        paint_wave(painting, 2.0, 14.0);
        painting.apply(TiltCanvas{80, 90});
        pass_ticks(60);
    }
    void pass_ticks(int count) {
        for (int tick = 0; tick < count; ++tick)
            painting.advance_tick();
    }
    void expect_balance() const {
        EXPECT_LT(painting.account().volume_error_rel(), kRounding);
        EXPECT_LT(painting.account().pigment_error_rel(), kRounding);
    }

    core::ThreadPool pool{2};
    Painting painting{small_canvas(), pool};
};

TEST_F(CanvasScaling, MadeOfFinerCellsItHoldsTheSamePaint) {
    const Account before = painting.account();
    ASSERT_GT(before.ledger.volume_mm3, 0.1);
    painting.apply(kFiner);
    EXPECT_EQ(painting.film().shape, (grid::Shape{240, 180}));
    EXPECT_EQ(painting.film().cell_mm, 1.0 / 6.0);
    EXPECT_EQ(painting.settings().px_per_mm, 6.0);
    EXPECT_EQ(painting.settings().width_mm, 40.0);
    const Account after = painting.account();
    EXPECT_NEAR(after.canvas.volume_mm3, before.canvas.volume_mm3, 1e-6 * before.canvas.volume_mm3);
    // Dry paint is as high as whole steps of a support, 2^-20 mm, in some 0.1 mm.
    EXPECT_NEAR(after.dried.volume_mm3, before.dried.volume_mm3, 1e-5 * before.dried.volume_mm3);
    EXPECT_NEAR(after.ledger.volume_mm3, before.ledger.volume_mm3, 1e-4 * before.ledger.volume_mm3);
    EXPECT_EQ(after.brush.volume_mm3, before.brush.volume_mm3);
    EXPECT_EQ(after.well.volume_mm3, before.well.volume_mm3);
    expect_balance();
}

TEST_F(CanvasScaling, DrawnOutItsPaintKeepsItsThickness) {
    const Account before = painting.account();
    painting.apply(kLarger);
    EXPECT_EQ(painting.film().shape, (grid::Shape{180, 135}));
    EXPECT_EQ(painting.settings().width_mm, 60.0);
    EXPECT_EQ(painting.settings().px_per_mm, 3.0);
    EXPECT_NEAR(painting.account().canvas.volume_mm3 / before.canvas.volume_mm3, 2.25, 0.01);
    expect_balance();
}

TEST_F(CanvasScaling, NarrowedItLosesWhatItHasNoRoomFor) {
    const Account before = painting.account();
    painting.apply(ScaleCanvas{0.7, 1.0, 1.0});
    EXPECT_EQ(painting.film().shape, (grid::Shape{84, 90}));
    EXPECT_NEAR(painting.account().canvas.volume_mm3 / before.canvas.volume_mm3, 0.7, 0.01);
    expect_balance();
}

TEST_F(CanvasScaling, TheClothIsWovenAnew) {
    painting.apply(kFiner);
    const Snapshot after = painting.snapshot();
    const film::SupportHeights anew = heights_of_cloth(after.bare->settings, pool);
    for (int y = 0; y < anew.shape().height; ++y)
        for (int x = 0; x < anew.shape().width; ++x)
            ASSERT_EQ(after.bare->support_mm.at(x, y), anew.at(x, y)) << x << ", " << y;
}

TEST_F(CanvasScaling, TheClothIsDrawnOutWithWhatLiesOnIt) {
    const Snapshot before = painting.snapshot();
    const ScaleCanvas uneven{1.3, 1.7, 1.0};
    painting.apply(uneven);
    const Snapshot after = painting.snapshot();
    EXPECT_EQ(after.bare->settings.support_map, (ClothMap{1.3, 0.0, 0.0, 1.7}));
    const film::SupportHeights carried =
        layers::resampled(before.bare->support_mm, resampling_of(uneven, before.bare->settings), pool);
    EXPECT_LT(apart_mm(after.bare->support_mm, carried), 1e-5);
    EXPECT_EQ(apart_mm(after.bare->support_mm, heights_of_cloth(after.bare->settings, pool)), 0.0)
        << "it is woven anew from its settings";
}

TEST_F(CanvasScaling, ANarrowedClothIsTheMeanOfTheOneBefore) {
    const Snapshot before = painting.snapshot();
    const ScaleCanvas half{0.5, 0.5, 1.0};
    const film::SupportHeights carried =
        layers::resampled(before.bare->support_mm, resampling_of(half, before.bare->settings), pool);
    const film::SupportHeights narrowed = heights_of_cloth(scaled(half, before.bare->settings), pool);
    double difference_mm2 = 0.0, relief_mm2 = 0.0;
    for (int y = 4; y < narrowed.shape().height - 4; ++y)
        for (int x = 4; x < narrowed.shape().width - 4; ++x) {
            difference_mm2 += std::pow(narrowed.at(x, y) - carried.at(x, y), 2);
            relief_mm2 += std::pow(carried.at(x, y), 2);
        }
    EXPECT_LT(std::sqrt(difference_mm2 / relief_mm2), 0.05);
}

TEST_F(CanvasScaling, DrawnOutAndNarrowedAgainTheClothIsTheSame) {
    const CanvasSettings there = scaled(ScaleCanvas{1.3, 0.7, 1.0}, small_canvas());
    CanvasSettings turned_there = rotated(RotateCanvas{40.0, true}, there);
    EXPECT_NE(turned_there.support_map, there.support_map);
    turned_there = rotated(RotateCanvas{-40.0, true}, turned_there);
    const CanvasSettings back = scaled(ScaleCanvas{1.0 / 1.3, 1.0 / 0.7, 1.0}, turned_there);
    EXPECT_EQ(back.support_map, ClothMap{});
    EXPECT_EQ(back.support_turn, core::Orientation{});
    EXPECT_NEAR(back.support_x_mm, 0.0, 1e-9);
    EXPECT_NEAR(back.support_y_mm, 0.0, 1e-9);
}

TEST_F(CanvasScaling, ATurnSwapsHowTheClothIsDrawnOut) {
    const CanvasSettings uneven = scaled(ScaleCanvas{1.3, 0.7, 1.0}, small_canvas());
    for (const core::Orientation turn : {core::Orientation{false, 1}, core::Orientation{true, 3}}) {
        const CanvasSettings turned_cloth = turned(turn, uneven);
        EXPECT_EQ(turned_cloth.support_map, (ClothMap{0.7, 0.0, 0.0, 1.3}));
        EXPECT_LT(apart_mm(heights_of_cloth(turned_cloth, pool),
                           layers::turned(heights_of_cloth(uneven, pool), turn, pool)),
                  1e-5);
    }
}

TEST_F(CanvasScaling, AClothThatIsDrawnOutGoesOnWhereTheCanvasIsMadeLarger) {
    const CanvasSettings drawn = scaled(ScaleCanvas{1.3, 1.3, 1.0}, small_canvas());
    const CanvasSettings larger =
        resized({-2.0, -3.0, drawn.width_mm + 5.0, drawn.height_mm + 5.0}, drawn);
    const film::SupportHeights woven = heights_of_cloth(drawn, pool),
                               around = heights_of_cloth(larger, pool);
    for (int y = 4; y < woven.shape().height - 4; ++y)
        for (int x = 4; x < woven.shape().width - 4; ++x)
            ASSERT_NEAR(around.at(x + 6, y + 9), woven.at(x, y), 1e-5) << x << ", " << y;
}

TEST_F(CanvasScaling, ClothsThatWouldBeDrawnOutTooFarAreRefused) {
    CanvasSettings narrow = scaled(ScaleCanvas{0.05, 0.05, 1.0}, small_canvas());
    narrow.width_mm = narrow.height_mm = 100.0;
    narrow = scaled(ScaleCanvas{0.05, 0.05, 1.0}, narrow);
    EXPECT_THROW(scaled(ScaleCanvas{0.9, 1.0, 1.0}, narrow), core::InputError);
}

TEST_F(CanvasScaling, ItGoesOnAsAPaintingOfThoseCells) {
    painting.apply(kFiner);
    pass_ticks(10);
    paint_wave(painting, 4.0, 18.0);
    pass_ticks(10);
    painting.apply(ScaleCanvas{1.0, 1.0, 0.4});
    EXPECT_EQ(painting.film().shape, (grid::Shape{96, 72}));
    paint_wave(painting, 6.0, 8.0);
    pass_ticks(10);
    expect_balance();
}

TEST_F(CanvasScaling, UndoGivesEveryBitBack) {
    const std::uint64_t before = painting.state_hash();
    const Account account = painting.account();
    painting.apply(kFiner);
    const std::uint64_t finer = painting.state_hash();
    EXPECT_EQ(painting.undo_steps().back().step.name, "Painting scaled");
    painting.apply(ScaleCanvas{2.0, 2.0, 0.5});  // as many cells, but others
    EXPECT_EQ(painting.film().shape, (grid::Shape{240, 180}));
    pass_ticks(3);
    painting.apply(Undo{});
    EXPECT_EQ(painting.state_hash(), finer);
    EXPECT_EQ(painting.film().cell_mm, 1.0 / 6.0);
    painting.apply(Undo{});
    EXPECT_EQ(painting.state_hash(), before);
    EXPECT_EQ(painting.settings(), small_canvas());
    EXPECT_NEAR(painting.account().ledger.volume_mm3, account.ledger.volume_mm3, kRounding);
    painting.apply(Redo{});
    EXPECT_EQ(painting.state_hash(), finer);
    expect_balance();
}

TEST_F(CanvasScaling, SelectionAndTracingComeAlong) {
    const auto picture =
        std::make_shared<const pigment::Picture>(pigment::Picture{2, 1, {1, 2, 3, 4, 5, 6, 7, 8}});
    painting.apply(LayTracing{picture, {4, 6, 8, 4}});
    painting.apply(SelectArea{{{10, 5}, {30, 5}, {30, 20}, {10, 20}}});
    painting.apply(ScaleCanvas{2.0, 1.0, 2.0});
    EXPECT_EQ(grid::chosen_area(*painting.state().value.selection), (grid::Rect{120, 30, 360, 120}));
    EXPECT_EQ(painting.state().value.tracing->place, (layers::PicturePlace{8, 6, 16, 4}));
}

TEST_F(CanvasScaling, WhatWasCopiedIsPastedAsWideAsItWas) {
    painting.apply(CopyPaint{2});
    const Account before = painting.account();
    painting.apply(PastePaint{"Before"});
    const double pasted_mm3 = painting.account().canvas.volume_mm3 - before.canvas.volume_mm3;
    painting.apply(kFiner);
    const Account finer = painting.account();
    painting.apply(PastePaint{"After"});
    EXPECT_NEAR(painting.account().canvas.volume_mm3 - finer.canvas.volume_mm3, pasted_mm3,
                1e-4 * pasted_mm3);
    expect_balance();
}

TEST_F(CanvasScaling, NothingIsNoStepAndWhatCannotBeIsRefused) {
    const std::uint64_t before = painting.state_hash();
    const std::size_t steps = painting.undo_steps().size();
    painting.apply(ScaleCanvas{});
    EXPECT_EQ(painting.undo_steps().size(), steps);
    EXPECT_THAT(error_of([&] {
                    painting.apply(ScaleCanvas{0.0, 1.0, 1.0});
                }),
                HasSubstr("scale of the width is 0"));
    EXPECT_THAT(error_of([&] {
                    painting.apply(ScaleCanvas{0.05, 0.05, 0.05});
                }),
                HasSubstr("resolution of the canvas is 0.15 px/mm"));
    EXPECT_THAT(error_of([&] {
                    painting.apply(ScaleCanvas{20.0, 20.0, 20.0});
                }),
                HasSubstr("at most 32768 a side are possible"));
    EXPECT_EQ(painting.state_hash(), before);
    EXPECT_EQ(painting.undo_steps().size(), steps);
}

TEST_F(CanvasScaling, ARecordingReplaysToTheSameBits) {
    Recording recording = crossing_session();
    recording.events.push_back({44, ScaleCanvas{1.3, 0.9, 1.4}});
    recording.events.push_back({45, PenDown{wave_sample(1.0, 9.0, 0)}});
    recording.events.push_back({50, PenMove{wave_sample(1.0, 9.0, 9)}});
    recording.events.push_back({51, PenUp{}});
    core::ThreadPool one(1), three(3);
    EXPECT_EQ(played(recording, one)->state_hash(), played(recording, three)->state_hash());
}

TEST_F(CanvasScaling, AtAnotherResolutionItScalesAlike) {
    Recording recording = crossing_session();
    recording.events.push_back({recording.end_tick, ScaleCanvas{1.0, 1.0, 2.0}});
    const auto coarse = played(recording, pool);
    recording.canvas.px_per_mm = 5.0;
    const auto fine = played(recording, pool);
    EXPECT_EQ(coarse->settings().px_per_mm, 6.0);
    EXPECT_EQ(fine->settings().px_per_mm, 10.0);
    const double coarse_mm3 = coarse->account().canvas.volume_mm3;
    EXPECT_NEAR(fine->account().canvas.volume_mm3, coarse_mm3, 0.1 * coarse_mm3);
}

}  // namespace
}  // namespace pastoso::document
