// Paint that is copied, as it is at that time, and laid down once more.
#include "document/error_of.hpp"
#include "document/painting.hpp"
#include "document/painting_state.hpp"
#include "document/played.hpp"
#include "document/scenes.hpp"
#include "layers/apart.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace pastoso::document {
namespace {

using testing::HasSubstr;

constexpr double kRounding = 1e-9;

class CopyingPaint : public testing::Test {
  protected:
    void SetUp() override {
        paint_dry_wave(painting);
        painting.apply(load_of("PY35"));
        paint_wave(painting, 1.0, 12.0);
    }
    const film::FilmState& layer_at(std::size_t place) {
        stack = painting.layers();
        return place == stack.active ? painting.film() : *stack.layers[place].inactive;
    }
    void select(double x0_mm, double y0_mm, double x1_mm, double y1_mm) {
        painting.apply(SelectArea{{{x0_mm, y0_mm}, {x1_mm, y0_mm}, {x1_mm, y1_mm}, {x0_mm, y1_mm}}});
    }
    void expect_balance() const {
        EXPECT_LT(painting.account().volume_error_rel(), kRounding);
        EXPECT_LT(painting.account().pigment_error_rel(), kRounding);
    }

    core::ThreadPool pool{2};
    Painting painting{small_canvas(), pool};
    LayerStack stack;
};

TEST_F(CopyingPaint, APastedLayerIsTheLayerToTheCell) {
    const film::FilmState before = painting.film();
    painting.apply(CopyPaint{1});
    EXPECT_EQ(painting.undo_steps().back().step.name, "Stroke");
    painting.apply(PastePaint{"Copy"});
    ASSERT_EQ(painting.layers().layers.size(), 2U);
    EXPECT_EQ(painting.layers().layers[1].look.name, "Copy");
    EXPECT_EQ(painting.layers().active, 1U);
    const film::FilmState& copy = layer_at(1);
    for (int y = 0; y < 90; ++y)
        for (int x = 0; x < 120; ++x) {
            ASSERT_EQ(copy.thickness.at(x, y), before.thickness.at(x, y)) << x << ", " << y;
            ASSERT_EQ(copy.paint.at(x, y), before.paint.at(x, y));
            ASSERT_EQ(copy.strata.optics.at(x, y), before.strata.optics.at(x, y));
        }
    expect_balance();
}

TEST_F(CopyingPaint, ItIsThePaintOfThatTimeWhateverBecomesOfTheLayer) {
    const Account before = painting.account();
    painting.apply(CopyPaint{1});
    const film::FilmState then = *painting.snapshot().copied;
    painting.apply(AddLayer{"Other"});
    painting.apply(RemoveLayer{1});
    for (int tick = 0; tick < 5; ++tick)
        painting.advance_tick();
    painting.apply(PastePaint{"Copy"});
    EXPECT_EQ(film::totals(layer_at(1)).thickness, film::totals(then).thickness);
    EXPECT_EQ(painting.account().canvas.volume_mm3, before.canvas.volume_mm3);
    EXPECT_EQ(painting.account().dried.volume_mm3, before.dried.volume_mm3);
    expect_balance();
}

TEST_F(CopyingPaint, OnlyWhatIsSelectedIsCopied) {
    const film::FilmState before = painting.film();
    select(10, 0, 20, 30);
    painting.apply(CopyPaint{1});
    painting.apply(PastePaint{"Piece"});
    const film::FilmState& piece = layer_at(1);
    for (int y = 0; y < 90; ++y)
        for (int x = 0; x < 120; ++x) {
            const bool inside = x >= 30 && x < 60;
            ASSERT_EQ(piece.thickness.at(x, y), inside ? before.thickness.at(x, y) : 0) << x;
        }
    EXPECT_GT(film::totals(piece).thickness, 0);
    expect_balance();
}

TEST_F(CopyingPaint, ItLiesSoFarFromWhereItWasInWholeCells) {
    const film::FilmState before = painting.film();
    select(10, 0, 20, 30);
    painting.apply(CopyPaint{1});
    painting.apply(PastePaint{"Piece", 5.1, -1.0});  // 15 and 3 cells
    EXPECT_EQ(layer_at(1).thickness.at(45 + 15, 36 - 3), before.thickness.at(45, 36));
    EXPECT_GT(before.thickness.at(45, 36), 0);
    const double taken_mm3 = painting.account().taken.volume_mm3;
    painting.apply(PastePaint{"Beside the canvas", 200.0, 0.0});
    EXPECT_EQ(painting.account().taken.volume_mm3, taken_mm3) << "no paint lies beside the canvas";
    expect_balance();
}

TEST_F(CopyingPaint, AllThatIsVisibleIsCopiedAsIfItWereFlattened) {
    painting.apply(AddLayer{"Above"});
    painting.apply(load_of("PR108"));
    paint_wave(painting, 2.0, 20.0);
    painting.apply(AddLayer{"Hidden"});
    paint_wave(painting, 3.0, 25.0);
    painting.apply(SetLayer{3, {.name = "Hidden", .visible = false}});
    Painting flat(painting.state(), pool);
    painting.apply(CopyPaint{});
    flat.apply(FlattenLayers{});
    const film::FilmState& copied = *painting.snapshot().copied;
    const LayerStack flattened = flat.layers();
    EXPECT_EQ(
        film::totals(copied).thickness,
        film::totals(flattened.active == 0 ? flat.film() : *flattened.layers[0].inactive).thickness);
    for (int place = 0; place < 3; ++place)
        painting.apply(SetLayer{static_cast<LayerId>(place + 1), {.name = "Hidden", .visible = false}});
    EXPECT_THAT(error_of([&] { painting.apply(CopyPaint{}); }), HasSubstr("no visible layer to copy"));
}

TEST_F(CopyingPaint, UndoTakesThePastedLayerAwayAndKeepsTheCopy) {
    const std::uint64_t before = painting.state_hash();
    painting.apply(CopyPaint{1});
    EXPECT_EQ(painting.state_hash(), before);
    painting.apply(PastePaint{"Copy"});
    const std::uint64_t pasted = painting.state_hash();
    EXPECT_EQ(painting.undo_steps().back().step.name, "Paint pasted");
    painting.apply(Undo{});
    EXPECT_EQ(painting.state_hash(), before);
    painting.apply(Redo{});
    EXPECT_EQ(painting.state_hash(), pasted);
    painting.apply(Undo{});
    painting.apply(Undo{});
    painting.apply(PastePaint{"Again"});
    expect_balance();
    EXPECT_EQ(painting.layers().layers.size(), 2U);
}

TEST_F(CopyingPaint, ItIsPastedOnACanvasThatHasBecomeAnother) {
    painting.apply(CopyPaint{1});
    painting.apply(ResizeCanvas{0, 0, 20, 15});
    painting.apply(TurnCanvas{{false, 1}});
    painting.apply(PastePaint{"Copy"});
    EXPECT_EQ(layer_at(1).shape, (grid::Shape{45, 60}));
    expect_balance();
}

TEST_F(CopyingPaint, WithoutACopyThereIsNothingToPaste) {
    EXPECT_THAT(error_of([&] { painting.apply(PastePaint{"None"}); }),
                HasSubstr("no paint has been copied"));
    EXPECT_THAT(error_of([&] { painting.apply(CopyPaint{9}); }), HasSubstr("layer"));
    EXPECT_EQ(painting.layers().layers.size(), 1U);
}

TEST_F(CopyingPaint, ARecordingReplaysToTheSameBits) {
    Recording recording = crossing_session();
    recording.events.push_back({44, SelectArea{{{8, 5}, {25, 5}, {25, 20}, {8, 20}}}});
    recording.events.push_back({44, CopyPaint{1}});
    recording.events.push_back({44, ClearLayer{1}});
    recording.events.push_back({50, PastePaint{"Piece", 4.0, 6.0}});
    recording.end_tick = 60;
    const auto hash_on = [](const Recording& what, int threads) {
        core::ThreadPool other(threads);
        const auto again = played(what, other);
        EXPECT_LT(again->account().volume_error_rel(), kRounding);
        EXPECT_EQ(again->layers().layers.size(), 2U);
        return again->state_hash();
    };
    EXPECT_EQ(hash_on(recording, 1), hash_on(recording, 3));
    recording.canvas.px_per_mm = 4.5;
    hash_on(recording, 2);
}

TEST_F(CopyingPaint, ARecordingPastesTheSamePieceAtAnyResolution) {
    const auto box = [](double x0_mm, double y0_mm, double x1_mm, double y1_mm) {
        return SelectArea{{{x0_mm, y0_mm}, {x1_mm, y0_mm}, {x1_mm, y1_mm}, {x0_mm, y1_mm}}};
    };
    Recording recording{.canvas = small_canvas(),
                        .events = {{0, UseMedium{"soft-body acrylic"}},
                                   {0, box(8, 5, 24, 20)},
                                   {0, FillWithPaint{.paint = {{{"PB29", 1.0}}}, .thickness_mm = 0.2}},
                                   {0, box(10, 5, 20, 20)},
                                   {0, CopyPaint{1}},
                                   {0, SelectAll{}},
                                   {0, PastePaint{"Piece", 12.0, 6.0}}}};
    for (const int px_per_mm : {3, 4, 7}) {
        const int p = px_per_mm;
        recording.canvas.px_per_mm = px_per_mm;
        const auto again = played(recording, pool);
        ASSERT_EQ(again->layers().active, 1U);
        again->apply(CopyPaint{again->layers().layers[1].id});
        EXPECT_EQ(layers::painted_area(*again->snapshot().copied),
                  (grid::Rect{22 * p, 11 * p, 32 * p, 26 * p}));
        // The film and a piece of it; cells hold whole quanta.
        EXPECT_NEAR(again->account().canvas.volume_mm3, 0.2 * (16.0 * 15.0 + 10.0 * 15.0), 1e-4) << p;
        EXPECT_LT(again->account().volume_error_rel(), kRounding);
    }
}

}  // namespace
}  // namespace pastoso::document
