// What a painting would look like with its dry paint adjusted, against the action that adjusts it.
#include "document/adjusted_preview.hpp"

#include "document/paint_mixing.hpp"
#include "document/scenes.hpp"

#include <gtest/gtest.h>

namespace pastoso::document {
namespace {

constexpr const char* kMedium = "soft-body acrylic";

CanvasSettings panel() {
    CanvasSettings canvas = small_canvas();
    canvas.support = "panel";
    canvas.px_per_mm = 4.0;  // 160 x 120 cells, 3 x 2 tiles
    return canvas;
}

SelectArea box(double x0_mm, double y0_mm, double x1_mm, double y1_mm) {
    return {{{x0_mm, y0_mm}, {x1_mm, y0_mm}, {x1_mm, y1_mm}, {x0_mm, y1_mm}}};
}

bool same_look(const film::FilmState& a, const film::FilmState& b, int x, int y) {
    return a.thickness.at(x, y) == b.thickness.at(x, y) && a.paint.at(x, y) == b.paint.at(x, y) &&
           a.support_mm.at(x, y) == b.support_mm.at(x, y) &&
           a.strata.optics.at(x, y) == b.strata.optics.at(x, y) &&
           a.strata.soluble_thickness.at(x, y) == b.strata.soluble_thickness.at(x, y) &&
           a.strata.soluble_pigment.at(x, y) == b.strata.soluble_pigment.at(x, y);
}

int different_cells(const film::FilmState& a, const film::FilmState& b) {
    int count = 0;
    for (int y = 0; y < a.shape.height; ++y)
        for (int x = 0; x < a.shape.width; ++x)
            count += !same_look(a, b, x, y);
    return count;
}

class AdjustedPreviewTest : public testing::Test {
  protected:
    void SetUp() override { painting.apply(UseMedium{kMedium}); }
    void lay(const char* pigment, const SelectArea& area, bool dry = true) {
        painting.apply(area);
        painting.apply(FillWithPaint{.paint = {{{pigment, 1.0}}}, .thickness_mm = 0.1});
        if (dry) painting.apply(DryNow{});
        painting.apply(SelectAll{});
    }
    void paint_over(double y_mm) {
        painting.apply(TakeBrush{"flat", 4, 1});
        painting.apply(load_of("PY35"));
        paint_wave(painting, 0.0, y_mm);
    }
    Snapshot previewed(const AdjustDryPaint& adjust, const PreviewStep& step) {
        return preview.of(painting.snapshot(),
                          {mixed_paint(adjust.paint, film::find_medium(kMedium)), adjust.way}, step,
                          pool);
    }
    Snapshot previewed(const AdjustDryPaint& adjust) {
        const Snapshot seen = previewed(adjust, {{}, painting.film().shape.tile_count()});
        EXPECT_TRUE(preview.complete());
        return seen;
    }
    /// Somewhere it changes what is seen, and the painting stays as it is.
    void expect_the_action(const AdjustDryPaint& adjust) {
        const std::uint64_t hash = painting.state_hash();
        const film::FilmState before = painting.snapshot().film;
        const Snapshot seen = previewed(adjust);
        EXPECT_EQ(painting.state_hash(), hash);
        EXPECT_GT(different_cells(seen.film, before), 0);
        painting.apply(adjust);
        EXPECT_EQ(different_cells(seen.film, painting.snapshot().film), 0);
        painting.apply(Undo{});
    }

    core::ThreadPool pool{2};
    Painting painting{panel(), pool};
    AdjustedPreview preview;
    const SelectArea all = box(0, 0, 40, 30), left = box(0, 0, 20, 30), middle = box(10, 5, 30, 25);
    const PaintRecipe red{{{"PR108", 1.0}}};
    const AdjustDryPaint glaze{red, layers::Glaze{0.02}}, exchange{red, layers::PaintExchange{0.4}};
};

TEST_F(AdjustedPreviewTest, LooksAsTheActionLeavesIt) {
    lay("PB29", all);
    expect_the_action(glaze);
    expect_the_action(exchange);
}

TEST_F(AdjustedPreviewTest, OfWhatIsSelectedAndNotMaskedBelowWetPaint) {
    lay("PB29", all);
    paint_over(10.0);
    painting.apply(box(25, 0, 30, 30));
    painting.apply(MaskSelection{});
    painting.apply(middle);
    expect_the_action(glaze);
    expect_the_action(exchange);
}

TEST_F(AdjustedPreviewTest, BetweenOtherLayersAFadedOneThatIsClipped) {
    lay("PB29", middle);
    painting.apply(AddLayer{"Between"});
    const LayerId between = painting.layers().layers[1].id;
    lay("PW6", left);
    painting.apply(SetLayer{between, {.name = "Between", .opacity = 0.5, .clipped = true}});
    painting.apply(AddLayer{"Above"});
    lay("PY35", box(0, 10, 40, 15), false);
    painting.apply(SelectLayer{between});
    expect_the_action(glaze);
    expect_the_action(exchange);
    painting.apply(SelectLayer{painting.layers().layers[0].id});
    expect_the_action(glaze);
}

TEST_F(AdjustedPreviewTest, TilesComeFromTheMiddleOfWhatIsSeenStepByStep) {
    lay("PB29", all);
    const PreviewStep upper_right{{140, 0, 160, 20}, 1}, upper_left{{0, 0, 20, 20}, 2};
    const film::FilmState before = painting.snapshot().film;
    const film::FilmState first = previewed(exchange, upper_right).film;
    EXPECT_FALSE(preview.complete());
    EXPECT_EQ(different_cells(first, before), 32 * 64) << "of tile 2, which the canvas cuts";
    EXPECT_TRUE(first.strata.optics.shares_tile(before.strata.optics, 0));
    EXPECT_TRUE(first.support_mm.shares_tile(before.support_mm, 0));
    const film::FilmState second = previewed(exchange, upper_left).film;
    EXPECT_EQ(different_cells(second, first), 64 * 64 + 64 * 56) << "of tiles 0 and 3";
    EXPECT_TRUE(second.strata.optics.shares_tile(first.strata.optics, 2)) << "not made anew";
    EXPECT_TRUE(second.support_mm.shares_tile(first.support_mm, 2));
    EXPECT_EQ(different_cells(previewed(exchange).film, before), 160 * 120);
}

TEST_F(AdjustedPreviewTest, WhatWasAdjustedOtherwiseStaysUntilItsTurn) {
    lay("PB29", all);
    const film::FilmState other = previewed(glaze).film;
    const film::FilmState first = previewed(exchange, {{0, 0, 20, 20}, 1}).film;
    EXPECT_FALSE(preview.complete());
    EXPECT_EQ(different_cells(first, other), 64 * 64);
    painting.apply(box(0, 0, 40, 10));
    const film::FilmState selected = previewed(exchange, {{0, 0, 20, 20}, 1}).film;
    EXPECT_EQ(different_cells(selected, painting.snapshot().film), 64 * 40)
        << "of another selection nothing stays";
}

TEST_F(AdjustedPreviewTest, FollowsStrokesAndWhatIsTakenBack) {
    lay("PB29", all);
    const film::FilmState first = previewed(glaze).film;
    paint_over(6.0);
    const film::FilmState painted = previewed(glaze).film;
    const int lower_row = 3;
    EXPECT_TRUE(painted.strata.optics.shares_tile(first.strata.optics, lower_row)) << "not made anew";
    expect_the_action(glaze);
    painting.apply(Undo{});
    EXPECT_EQ(different_cells(previewed(glaze).film, first), 0);
}

TEST_F(AdjustedPreviewTest, WhereNothingIsDryTilesAreThePaintings) {
    lay("PB29", box(0, 0, 5, 5));
    paint_over(20.0);
    const film::FilmState before = painting.snapshot().film;
    const film::FilmState seen = previewed(glaze).film;
    EXPECT_FALSE(seen.support_mm.shares_tile(before.support_mm, 0));
    for (int tile = 1; tile < before.shape.tile_count(); ++tile)
        EXPECT_TRUE(seen.support_mm.shares_tile(before.support_mm, tile) &&
                    seen.paint.shares_tile(before.paint, tile))
            << tile;
}

TEST_F(AdjustedPreviewTest, AnotherCanvasIsSeenFromItsBeginning) {
    lay("PB29", all);
    previewed(glaze);
    painting.apply(ResizeCanvas{.width_mm = 60.0, .height_mm = 50.0});
    expect_the_action(glaze);
}

}  // namespace
}  // namespace pastoso::document
