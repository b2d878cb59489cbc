// Media that change where paint of another one lies, is carried or comes back.
#include "document/media_cases.hpp"
#include "document/player.hpp"
#include "document/well_session.hpp"

namespace pastoso::document {
namespace {

class MediaChanges : public testing::Test {
  protected:
    void SetUp() override { play(standing_oil(), painting); }

    static void play(const Recording& recording, Painting& painting) {
        Player player(painting, recording);
        while (!player.finished())
            player.play_tick();
    }
    /// Layer 1 is active, with paint on it; for a second the canvas stands upright.
    void expect_it_stands(LayerId layer = 1) {
        go_on(painting, {SelectLayer{layer}});
        const film::FilmState before = paint_of(painting, layer);
        go_on(painting, {}, 60);
        expect_untouched(before, paint_of(painting, layer));
    }
    core::ThreadPool pool{1};
    Painting painting{small_canvas(), pool};
};

TEST_F(MediaChanges, PaintOnTheBrushStaysWhatItIsOnAnotherLayer) {
    go_on(painting, {load_of("PY35"), UseMedium{"thinner"}, AddLayer{"Above"}});
    paint_wave(painting, 1.0, 12.0);
    expect_it_stands(2);
}

TEST_F(MediaChanges, AStrokeDuringWhichTheMediumChangesIsOfThePaintOnTheBrush) {
    go_on(painting, {AddLayer{"Above"}, load_of("PY35"), PenDown{wave_sample(1.0, 12.0, 0)}});
    for (int i = 1; i <= 30; ++i) {
        if (i == 15) painting.apply(UseMedium{"thinner"});
        painting.apply(PenMove{wave_sample(1.0, 12.0, i)});
    }
    painting.apply(PenUp{});
    expect_it_stands(2);
    expect_it_stands(1);
}

TEST_F(MediaChanges, ASymmetricStrokeIsOfThePaintOnTheBrush) {
    go_on(painting, {load_of("PY35"), UseMedium{"ink glaze"}, AddLayer{"Above"},
                     SetSymmetry{{.centre_x_mm = 20, .centre_y_mm = 15, .mirror = true, .count = 2}}});
    paint_wave(painting, 1.0, 8.0);
    expect_it_stands(2);
}

TEST_F(MediaChanges, WhatIsCarriedFromPaintOfAnotherMediumStays) {
    go_on(painting, {AddLayer{"Above"}, CleanBrush{}, UseMedium{"ink glaze"}, SelectLayer{1}});
    paint_wave(painting, 1.0, 10.0);  // picks up oil
    ASSERT_GT(painting.account().brush.volume_mm3, 0.0);
    go_on(painting, {SelectLayer{2}});
    paint_wave(painting, 2.0, 14.0);
    const film::FilmState carried = paint_of(painting, 2);
    go_on(painting, {}, 30);
    EXPECT_EQ(film::totals(paint_of(painting, 2)).thickness, film::totals(carried).thickness);
    EXPECT_LT(moved_share(carried, paint_of(painting, 2)), 0.02);
}

TEST_F(MediaChanges, TheWellThatUndoBringsBackHoldsWhatWasInIt) {
    go_on(painting, {squeeze_of("PB29", 60, 45)}, 60);
    const film::FilmState before = *painting.well();
    go_on(painting, {CleanWell{}, CleanBrush{}, UseMedium{"thinner"}, Undo{}}, 60);
    ASSERT_NE(painting.well(), nullptr);
    expect_untouched(before, *painting.well());
}

TEST_F(MediaChanges, LayersOfTwoMediaStayApartWhenTheyAreMerged) {
    go_on(painting, {AddLayer{"Below the oil"}, CleanBrush{}, UseMedium{"soft-body acrylic"},
                     load_of("PY35", 0.5)});
    paint_wave(painting, 1.0, 25.0);
    go_on(painting, {}, 10);
    const film::Totals oil = film::totals(paint_of(painting, 1));
    const film::Totals acrylic = film::totals(paint_of(painting, 2));
    go_on(painting, {CleanBrush{}, UseMedium{"thinner"}, MergeDown{2}});
    const film::Totals both = film::totals(paint_of(painting, 1));
    EXPECT_EQ(both.thickness, oil.thickness + acrylic.thickness);
    for (const int channel : {film::kViscosityChannel, film::kYieldChannel})
        EXPECT_EQ(both.paint[channel], oil.paint[channel] + acrylic.paint[channel]);
    const film::FilmState merged = paint_of(painting, 1);
    go_on(painting, {}, 30);
    // The acrylic yields where it is thick: its stripe may settle, as it does alone.
    EXPECT_EQ(film::totals(paint_of(painting, 1)).thickness, both.thickness);
    EXPECT_LT(moved_share(merged, paint_of(painting, 1)), 0.1);
}

/// Each lies in tiles of its own, so that merging mixes nothing.
TEST_F(MediaChanges, LayersOfTwoMediaThatNowhereMeetAreMergedIntoOneOfBoth) {
    CanvasSettings broad = small_canvas();
    broad.width_mm = 120.0;
    Painting wide(broad, pool);
    play(standing_oil(), wide);
    go_on(wide, {AddLayer{"Beside"}, CleanBrush{}, UseMedium{"ink glaze"}, load_of("PY35", 0.3)});
    go_on(wide, line_on(Surface::Canvas, 1.0, 90, 110, 15));
    go_on(wide, {MergeDown{2}});
    const film::FilmState merged = paint_of(wide, 1);
    go_on(wide, {}, 20);
    const film::FilmState after = paint_of(wide, 1);
    for (int y = 0; y < after.shape.height; ++y)
        for (int x = 0; x < 3 * 45; ++x)
            ASSERT_NEAR(film::thickness_mm(after.thickness.at(x, y)),
                        film::thickness_mm(merged.thickness.at(x, y)), 0.1)
                << "the oil stands, " << x << ", " << y;
}

TEST_F(MediaChanges, WhatIsTransformedOrResizedStaysWhatItIs) {
    go_on(painting, {AddLayer{"Above"}, CleanBrush{}, UseMedium{"thinner"},
                     TransformLayer{1, {.move_x_mm = 1.0, .move_y_mm = 3.0}}});
    expect_it_stands();
    go_on(painting, {SelectLayer{2}, ResizeCanvas{-4, -4, 50, 40}});
    expect_it_stands();
}

TEST_F(MediaChanges, WhatIsLeftOfAClearedLayerStaysWhatItIs) {
    go_on(painting, {AddLayer{"Above"}, CleanBrush{}, UseMedium{"thinner"},
                     SelectArea{{{0, 0}, {15, 0}, {15, 30}, {0, 30}}}, ClearLayer{1}, SelectAll{}});
    expect_it_stands();
}

TEST_F(MediaChanges, ChangingBackAndForthChangesNothing) {
    const film::FilmState before = paint_of(painting, 1);
    go_on(painting, {AddLayer{"Above"}, CleanBrush{}});
    for (int i = 0; i < 20; ++i)
        for (const char* name : {"thinner", "heavy-body oil", "ink glaze", "heavy-body oil"})
            go_on(painting, {UseMedium{name}, SelectLayer{1}, SelectLayer{2}});
    go_on(painting, {SelectLayer{1}}, 30);
    expect_untouched(before, paint_of(painting, 1));
}

TEST_F(MediaChanges, AtAnyResolutionPaintStaysWhatItIs) {
    for (const double px_per_mm : {1.5, 2.0, 4.0}) {
        SCOPED_TRACE(px_per_mm);
        Recording recording = standing_oil();
        recording.canvas.px_per_mm = px_per_mm;
        Painting other(recording.canvas, pool);
        play(recording, other);
        const film::FilmState before = paint_of(other, 1);
        go_on(other, {AddLayer{"Above"}, CleanBrush{}, UseMedium{"thinner"}, SelectLayer{1}}, 30);
        const film::FilmState after = paint_of(other, 1);
        EXPECT_EQ(film::totals(after).thickness, film::totals(before).thickness);
        // Coarse cells have coarse edges, where the contact angle draws paint in.
        EXPECT_LT(moved_share(before, after), 0.05);
    }
}

TEST_F(MediaChanges, ALayerOnWhichNothingIsWetBeginsAnew) {
    go_on(painting,
          {DryNow{}, AddLayer{"Above"}, CleanBrush{}, UseMedium{"house paint"}, SelectLayer{1}});
    EXPECT_EQ(painting.film().consistencies.uniform(),
              film::consistency_of(film::find_medium("house paint")));
}

}  // namespace
}  // namespace pastoso::document
