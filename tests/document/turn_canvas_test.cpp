// A canvas that is mirrored and turned with all that lies on it.
#include "document/cloth.hpp"
#include "document/error_of.hpp"
#include "document/painting.hpp"
#include "document/painting_state.hpp"
#include "document/played.hpp"
#include "document/scenes.hpp"

#include <memory>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace pastoso::document {
namespace {

using testing::HasSubstr;

constexpr core::Orientation kMirror{true, 0}, kUpsideDown{true, 2}, kRight{false, 1}, kLeft{false, 3},
    kAround{false, 2};

class CanvasTurning : public testing::Test {
  protected:
    /// Dry paint, wet paint that runs, paint on the well, two layers, and one of them hidden.
    void SetUp() override {
        paint_dry_wave(painting);
        painting.apply(load_of("PY35"));
        paint_wave(painting, 1.0, 22.0);
        painting.apply(AddLayer{"Above"});
        painting.apply(SqueezePaint{{{{"PR108", 1.0}}, 1.0}, 50.0, 30.0, 30.0});
        paint_wave(painting, 2.0, 14.0);
        painting.apply(TiltCanvas{70, 90});
        pass_ticks(6);
    }
    void pass_ticks(int count) {
        for (int tick = 0; tick < count; ++tick)
            painting.advance_tick();
    }
    std::uint64_t hash_after(std::initializer_list<core::Orientation> turns) {
        Painting other(painting.state(), pool);
        for (const core::Orientation& turn : turns)
            other.apply(TurnCanvas{turn});
        return other.state_hash();
    }

    core::ThreadPool pool{2};
    Painting painting{small_canvas(), pool};
};

void expect_same(const Account::Amount& a, const Account::Amount& b) {
    EXPECT_EQ(a.volume_mm3, b.volume_mm3);
    EXPECT_EQ(a.pigment, b.pigment);
}

TEST_F(CanvasTurning, BackAgainItIsTheSameToTheBit) {
    const std::uint64_t before = painting.state_hash();
    EXPECT_NE(hash_after({kMirror}), before);
    EXPECT_EQ(hash_after({kMirror, kMirror}), before);
    EXPECT_EQ(hash_after({kUpsideDown, kUpsideDown}), before);
    EXPECT_EQ(hash_after({kRight, kRight, kRight, kRight}), before);
    EXPECT_EQ(hash_after({kLeft, kRight}), before);
    EXPECT_EQ(hash_after({kMirror, kUpsideDown, kAround}), before);
    painting.apply(TurnCanvas{kRight});
    EXPECT_NE(painting.settings(), small_canvas());
    painting.apply(TurnCanvas{kLeft});
    EXPECT_EQ(painting.settings(), small_canvas());
}

TEST_F(CanvasTurning, EveryLayerClothAndSightTurnTogether) {
    const Snapshot before = painting.snapshot();
    painting.apply(TurnCanvas{kRight});
    const Snapshot after = painting.snapshot();
    EXPECT_EQ(after.film.shape, (grid::Shape{90, 120}));
    EXPECT_EQ(painting.settings().width_mm, 30.0);
    EXPECT_EQ(painting.settings().height_mm, 40.0);
    for (int y = 0; y < 90; ++y)
        for (int x = 0; x < 120; ++x) {
            ASSERT_EQ(after.film.thickness.at(89 - y, x), before.film.thickness.at(x, y));
            ASSERT_EQ(after.film.support_mm.at(89 - y, x), before.film.support_mm.at(x, y));
            ASSERT_EQ(after.film.strata.optics.at(89 - y, x), before.film.strata.optics.at(x, y));
            ASSERT_EQ(after.bare->support_mm.at(89 - y, x), before.bare->support_mm.at(x, y));
            ASSERT_EQ(after.layers->layers[0].inactive->thickness.at(89 - y, x),
                      before.layers->layers[0].inactive->thickness.at(x, y));
        }
}

TEST_F(CanvasTurning, NoPaintComesOrGoes) {
    const Account before = painting.account();
    const std::uint64_t well = film::state_hash(*painting.well());
    painting.apply(TurnCanvas{kUpsideDown});
    const Account after = painting.account();
    expect_same(after.taken, before.taken);
    expect_same(after.canvas, before.canvas);
    expect_same(after.dried, before.dried);
    expect_same(after.brush, before.brush);
    expect_same(after.ledger, before.ledger);
    expect_same(after.well, before.well);
    EXPECT_EQ(film::state_hash(*painting.well()), well);
}

TEST_F(CanvasTurning, ItsClothIsTheTurnedClothWhereverItIsMadeAnew) {
    painting.apply(ResizeCanvas{5, 4, 20, 17});
    for (const core::Orientation& turn : {kRight, kMirror, core::Orientation{true, 1}}) {
        painting.apply(TurnCanvas{turn});
        const BareCanvas bare = *painting.snapshot().bare;
        const film::SupportHeights anew = heights_of_cloth(bare.settings, pool);
        for (int y = 0; y < anew.shape().height; ++y)
            for (int x = 0; x < anew.shape().width; ++x)
                ASSERT_EQ(anew.at(x, y), bare.support_mm.at(x, y)) << x << ", " << y;
    }
}

TEST_F(CanvasTurning, ACanvasThatIsTurnedGrowsByItsOwnCloth) {
    const film::SupportHeights whole = painting.snapshot().bare->support_mm;
    painting.apply(ResizeCanvas{10, 5, 20, 20});
    painting.apply(TurnCanvas{kRight});
    painting.apply(ResizeCanvas{-5, -10, 30, 40});
    const film::SupportHeights now = painting.snapshot().bare->support_mm;
    for (int y = 0; y < 90; ++y)
        for (int x = 0; x < 120; ++x)
            ASSERT_EQ(now.at(89 - y, x), whole.at(x, y)) << x << ", " << y;
}

TEST_F(CanvasTurning, SelectionAndTracingComeAlong) {
    const auto picture =
        std::make_shared<const pigment::Picture>(pigment::Picture{2, 1, {1, 2, 3, 4, 5, 6, 7, 8}});
    painting.apply(LayTracing{picture, {4, 6, 8, 4}});
    painting.apply(SelectArea{{{10, 5}, {30, 5}, {30, 20}, {10, 20}}});
    painting.apply(TurnCanvas{kRight});
    EXPECT_EQ(grid::chosen_area(*painting.state().value.selection), (grid::Rect{30, 30, 75, 90}));
    EXPECT_EQ(painting.state().value.tracing->place, (layers::PicturePlace{20, 4, 4, 8}));
    EXPECT_EQ(painting.state().value.tracing->picture->height, 2);
}

TEST_F(CanvasTurning, WetPaintThatRestsGoesOnResting) {
    Painting still(small_canvas(), pool);
    still.apply(UseMedium{"heavy-body oil"});
    still.apply(TakeBrush{"flat", 8, 1});
    still.apply(load_of("PB29"));
    paint_wave(still, 0.0, 12.0);
    const auto awake = [&] { return still.state().solver.awake.size(); };
    for (int tick = 0; tick < 3600 && awake() > 0; ++tick)
        still.advance_tick();
    ASSERT_EQ(awake(), 0U);
    ASSERT_TRUE(film::has_wet_paint(still.film()));
    still.apply(TurnCanvas{kMirror});
    EXPECT_EQ(awake(), 0U);
}

TEST_F(CanvasTurning, PaintRunsOnFromWhereItWas) {
    painting.apply(TurnCanvas{kAround});
    const std::uint64_t turned = painting.state_hash();
    pass_ticks(10);
    EXPECT_NE(painting.state_hash(), turned);
    EXPECT_LT(painting.account().volume_error_rel(), 1e-9);
}

TEST_F(CanvasTurning, UndoTurnsBackAndSaysWhat) {
    const std::uint64_t before = painting.state_hash();
    painting.apply(TurnCanvas{kMirror});
    const std::uint64_t mirrored = painting.state_hash();
    EXPECT_EQ(painting.undo_steps().back().step.name, "Canvas mirrored");
    painting.apply(TurnCanvas{kLeft});
    EXPECT_EQ(painting.undo_steps().back().step.name, "Canvas turned");
    pass_ticks(3);
    painting.apply(Undo{});
    EXPECT_EQ(painting.state_hash(), mirrored);
    painting.apply(Undo{});
    EXPECT_EQ(painting.state_hash(), before);
    EXPECT_EQ(painting.settings(), small_canvas());
    painting.apply(Redo{});
    EXPECT_EQ(painting.state_hash(), mirrored);
}

TEST_F(CanvasTurning, NoTurnIsNoStep) {
    const std::size_t steps = painting.undo_steps().size();
    painting.apply(TurnCanvas{});
    EXPECT_EQ(painting.undo_steps().size(), steps);
    EXPECT_THAT(error_of([&] {
                    painting.apply(TurnCanvas{{false, 4}});
                }),
                HasSubstr("number of quarter turns is 4"));
}

TEST_F(CanvasTurning, ARecordingReplaysToTheSameBits) {
    Recording recording = crossing_session();
    recording.events.push_back({44, TurnCanvas{kRight}});
    recording.events.push_back({45, PenDown{wave_sample(1.0, 9.0, 0)}});
    recording.events.push_back({50, PenMove{wave_sample(1.0, 9.0, 9)}});
    recording.events.push_back({51, PenUp{}});
    recording.events.push_back({52, TurnCanvas{kMirror}});
    core::ThreadPool one(1), three(3);
    EXPECT_EQ(played(recording, one)->state_hash(), played(recording, three)->state_hash());
}

TEST_F(CanvasTurning, AtAnotherResolutionItTurnsAlike) {
    Recording recording = crossing_session();
    recording.canvas.px_per_mm = 4.7;
    const auto upright = played(recording, pool);
    recording.events.push_back({recording.end_tick, TurnCanvas{kRight}});
    const auto right = played(recording, pool);
    const grid::Shape shape = upright->film().shape;
    EXPECT_EQ(shape, (grid::Shape{188, 141}));
    for (int y = 0; y < shape.height; ++y)
        for (int x = 0; x < shape.width; ++x)
            ASSERT_EQ(right->film().thickness.at(shape.height - 1 - y, x),
                      upright->film().thickness.at(x, y));
}

}  // namespace
}  // namespace pastoso::document
