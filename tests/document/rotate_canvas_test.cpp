// A canvas on which everything is turned by any angle.
#include "document/canvas.hpp"
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

class CanvasRotating : public testing::Test {
  protected:
    /// Dry paint, wet paint of two media, paint on the well, and two layers.
    void SetUp() override {
        paint_dry_wave(painting);
        painting.apply(load_of("PY35"));
        paint_wave(painting, 1.0, 22.0);
        painting.apply(CleanBrush{});
        painting.apply(UseMedium{"heavy-body oil"});
        painting.apply(load_of("PR108"));
        painting.apply(AddLayer{"Above"});
        painting.apply(SqueezePaint{{{{"PR108", 1.0}}, 1.0}, 50.0, 30.0, 30.0});
        paint_wave(painting, 2.0, 14.0);
    }
    void expect_balance() const {
        EXPECT_LT(painting.account().volume_error_rel(), kRounding);
        EXPECT_LT(painting.account().pigment_error_rel(), kRounding);
    }

    core::ThreadPool pool{2};
    Painting painting{small_canvas(), pool};
};

TEST_F(CanvasRotating, GrowsToHoldAllOfIt) {
    const Account before = painting.account();
    painting.apply(RotateCanvas{30.0});
    // 40 x 30 mm.
    EXPECT_NEAR(painting.settings().width_mm, 40 * std::sqrt(0.75) + 15, 1e-6);
    EXPECT_NEAR(painting.settings().height_mm, 20 + 30 * std::sqrt(0.75), 1e-6);
    EXPECT_EQ(painting.film().shape, (grid::Shape{149, 138}));
    const Account after = painting.account();
    EXPECT_NEAR(after.canvas.volume_mm3, before.canvas.volume_mm3, 1e-6 * before.canvas.volume_mm3);
    EXPECT_NEAR(after.dried.volume_mm3, before.dried.volume_mm3, 1e-4 * before.dried.volume_mm3);
    EXPECT_EQ(after.well.volume_mm3, before.well.volume_mm3);
    expect_balance();
}

TEST_F(CanvasRotating, KeepingItsSizeItLosesItsCorners) {
    painting.apply(ToneGround{{{{"PW6", 1.0}}}, 0.1, "Ground"});
    const double before_mm3 = painting.account().dried.volume_mm3;
    painting.apply(RotateCanvas{45.0, true});
    EXPECT_EQ(painting.settings().width_mm, small_canvas().width_mm);
    EXPECT_EQ(painting.settings().height_mm, small_canvas().height_mm);
    EXPECT_EQ(painting.film().shape, (grid::Shape{120, 90}));
    EXPECT_LT(painting.account().dried.volume_mm3, 0.9 * before_mm3);
    expect_balance();
}

TEST_F(CanvasRotating, TurnsClockwiseAboutTheMiddle) {
    Painting bare(small_canvas(), pool);
    bare.apply(SelectArea{{{30, 14}, {32, 14}, {32, 16}, {30, 16}}});
    bare.apply(RotateCanvas{90.0, true});
    // 11 mm to the right of the middle (20, 15), now below it.
    EXPECT_EQ(grid::chosen_area(*bare.state().value.selection), (grid::Rect{57, 75, 63, 81}));
}

TEST_F(CanvasRotating, ByQuartersItTurnsEveryCell) {
    Painting other(painting.state(), pool);
    painting.apply(RotateCanvas{180.0});
    other.apply(TurnCanvas{{false, 2}});
    const film::FilmState &one = painting.film(), &same = other.film();
    ASSERT_EQ(one.shape, same.shape);
    for (int y = 0; y < one.shape.height; ++y)
        for (int x = 0; x < one.shape.width; ++x) {
            ASSERT_EQ(one.thickness.at(x, y), same.thickness.at(x, y)) << x << ", " << y;
            ASSERT_EQ(one.paint.at(x, y), same.paint.at(x, y)) << x << ", " << y;
        }
    painting.apply(RotateCanvas{90.0});
    EXPECT_EQ(painting.film().shape, (grid::Shape{90, 120}));
    expect_balance();
}

TEST_F(CanvasRotating, ThereAndBackGivesTheVolumeBack) {
    const Account before = painting.account();
    painting.apply(RotateCanvas{17.0});
    painting.apply(RotateCanvas{-17.0});
    EXPECT_NEAR(painting.account().canvas.volume_mm3, before.canvas.volume_mm3,
                1e-5 * before.canvas.volume_mm3);
    expect_balance();
}

TEST_F(CanvasRotating, TheClothTurnsWithWhatLiesOnIt) {
    const Snapshot before = painting.snapshot();
    painting.apply(RotateCanvas{30.0, true});
    const Snapshot after = painting.snapshot();
    EXPECT_EQ(after.bare->settings.support_map, cloth_turned_by(30.0));
    const layers::Resampling turn = resampling_of(RotateCanvas{30.0, true}, before.bare->settings);
    const film::SupportHeights carried = layers::resampled(before.bare->support_mm, turn, pool);
    int compared = 0;
    for (int y = 30; y < 60; ++y)
        for (int x = 40; x < 80; ++x, ++compared)
            ASSERT_NEAR(after.bare->support_mm.at(x, y), carried.at(x, y), 1e-5) << x << ", " << y;
    EXPECT_EQ(compared, 1200);
    EXPECT_EQ(apart_mm(heights_of_cloth(after.bare->settings, pool), after.bare->support_mm), 0.0)
        << "it is woven anew from its settings";
}

void expect_map(const ClothMap& map, const ClothMap& expected) {
    EXPECT_NEAR(map.xx, expected.xx, kRounding);
    EXPECT_NEAR(map.xy, expected.xy, kRounding);
    EXPECT_NEAR(map.yx, expected.yx, kRounding);
    EXPECT_NEAR(map.yy, expected.yy, kRounding);
}

TEST_F(CanvasRotating, TurnsOfTheClothAddUpAndFoldIntoQuarters) {
    painting.apply(RotateCanvas{30.0, true});
    painting.apply(RotateCanvas{50.0, true});
    CanvasSettings settings = painting.settings();
    EXPECT_EQ(settings.support_turn, (core::Orientation{false, 1}));
    expect_map(settings.support_map, cloth_turned_by(-10.0));
    const film::SupportHeights woven = heights_of_cloth(settings, pool);
    CanvasSettings at_once = rotated(RotateCanvas{80.0, true}, small_canvas());
    EXPECT_LT(apart_mm(heights_of_cloth(at_once, pool), woven), 1e-5);
    settings = rotated(RotateCanvas{-80.0, true}, settings);
    EXPECT_EQ(settings.support_turn, core::Orientation{});
    EXPECT_EQ(settings.support_map, ClothMap{}) << "no rounding is left of it";
    EXPECT_NEAR(settings.support_x_mm, 0.0, kRounding);
}

TEST_F(CanvasRotating, AClothThatLiesAskewIsCutEnlargedAndMirroredInItsPlace) {
    const CanvasSettings askew = rotated(RotateCanvas{20.0}, small_canvas());
    const film::SupportHeights woven = heights_of_cloth(askew, pool);
    const CanvasSettings larger =
        resized({-2.0, -3.0, askew.width_mm + 5.0, askew.height_mm + 5.0}, askew);
    const film::SupportHeights around = heights_of_cloth(larger, pool);
    const CanvasSettings mirror = turned(core::Orientation{true, 1}, askew);
    const film::SupportHeights mirrored = heights_of_cloth(mirror, pool);
    const film::SupportHeights told = layers::turned(woven, core::Orientation{true, 1}, pool);
    for (int y = 4; y < woven.shape().height - 4; ++y)
        for (int x = 4; x < woven.shape().width - 4; ++x)
            ASSERT_NEAR(around.at(x + 6, y + 9), woven.at(x, y), 1e-5) << x << ", " << y;
    expect_map(mirror.support_map, cloth_turned_by(-20.0));
    ASSERT_EQ(mirrored.shape(), told.shape());
    EXPECT_LT(apart_mm(mirrored, told), 1e-5);
}

TEST_F(CanvasRotating, UndoGivesEveryBitBack) {
    const std::uint64_t before = painting.state_hash();
    painting.apply(RotateCanvas{7.0});
    EXPECT_EQ(painting.undo_steps().back().step.name, "Painting rotated");
    painting.advance_tick();
    const std::uint64_t after = painting.state_hash();
    painting.apply(Undo{});
    EXPECT_EQ(painting.state_hash(), before);
    EXPECT_EQ(painting.settings(), small_canvas());
    painting.apply(Redo{});
    EXPECT_EQ(painting.state_hash(), after);
    expect_balance();
}

TEST_F(CanvasRotating, TracingComesAlong) {
    const auto picture =
        std::make_shared<const pigment::Picture>(pigment::Picture{2, 1, {1, 2, 3, 4, 5, 6, 7, 8}});
    painting.apply(LayTracing{picture, {24, 14, 8, 4}});
    painting.apply(RotateCanvas{90.0, true});
    const layers::PicturePlace& place = painting.state().value.tracing->place;
    // From 4 to 12 right of the middle (20, 15), 1 above it to 3 below it.
    EXPECT_NEAR(place.x_mm, 17.0, kRounding);
    EXPECT_NEAR(place.y_mm, 19.0, kRounding);
    EXPECT_NEAR(place.width_mm, 4.0, kRounding);
    EXPECT_NEAR(place.height_mm, 8.0, kRounding);
    EXPECT_EQ(painting.state().value.tracing->picture->height, 2);
}

TEST_F(CanvasRotating, GoesOnBeingPaintedAndResized) {
    painting.apply(RotateCanvas{12.0});
    paint_wave(painting, 4.0, 20.0);
    painting.advance_tick();
    painting.apply(TurnCanvas{{true, 1}});
    painting.apply(RotateCanvas{-30.0, true});
    painting.apply(ScaleCanvas{0.8, 0.8, 1.5});
    painting.apply(RotateCanvas{3.0});
    paint_wave(painting, 6.0, 8.0);
    painting.apply(DryNow{});
    expect_balance();
}

TEST_F(CanvasRotating, NothingIsNoStepAndWhatCannotBeIsRefused) {
    const std::uint64_t before = painting.state_hash();
    const std::size_t steps = painting.undo_steps().size();
    painting.apply(RotateCanvas{});
    painting.apply(RotateCanvas{-360.0, true});
    EXPECT_EQ(painting.undo_steps().size(), steps);
    EXPECT_THAT(error_of([&] { painting.apply(RotateCanvas{361.0}); }),
                HasSubstr("turn of the canvas in degrees is 361"));
    EXPECT_EQ(painting.state_hash(), before);
    CanvasSettings wide = small_canvas();
    wide.width_mm = wide.height_mm = 4500.0;
    wide.px_per_mm = 0.25;
    EXPECT_THAT(error_of([&] { rotated(RotateCanvas{45.0}, wide); }),
                HasSubstr("width of the canvas is 6363.96"));
}

TEST_F(CanvasRotating, ARecordingReplaysToTheSameBits) {
    Recording recording = crossing_session();
    recording.events.push_back({44, RotateCanvas{22.5}});
    recording.events.push_back({45, PenDown{wave_sample(1.0, 9.0, 0)}});
    recording.events.push_back({50, PenMove{wave_sample(1.0, 9.0, 9)}});
    recording.events.push_back({51, PenUp{}});
    core::ThreadPool one(1), three(3);
    EXPECT_EQ(played(recording, one)->state_hash(), played(recording, three)->state_hash());
}

TEST_F(CanvasRotating, AtAnotherResolutionItTurnsAlike) {
    Recording recording = crossing_session();
    recording.events.push_back({recording.end_tick, RotateCanvas{-8.0}});
    const auto coarse = played(recording, pool);
    recording.canvas.px_per_mm = 6.0;
    const auto fine = played(recording, pool);
    EXPECT_EQ(coarse->settings().width_mm, fine->settings().width_mm);
    EXPECT_NEAR(fine->film().shape.width, 2 * coarse->film().shape.width, 1);
    const double coarse_mm3 = coarse->account().canvas.volume_mm3;
    EXPECT_NEAR(fine->account().canvas.volume_mm3, coarse_mm3, 0.1 * coarse_mm3);
}

}  // namespace
}  // namespace pastoso::document
