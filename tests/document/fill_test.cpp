// Even films of paint poured onto the canvas.
#include "document/error_of.hpp"
#include "document/painting.hpp"
#include "document/painting_state.hpp"
#include "document/scenes.hpp"

#include <gmock/gmock.h>

namespace pastoso::document {
namespace {

using testing::HasSubstr;

/// As in painting_test.cpp.
constexpr double kRounding = 1e-9;

CanvasSettings panel_of(double px_per_mm) {
    CanvasSettings canvas = small_canvas();
    canvas.support = "panel";
    canvas.px_per_mm = px_per_mm;
    return canvas;
}

PaintRecipe paint_of(const char* pigment) {
    return {{{pigment, 1.0}}};
}

SelectArea left_half() {
    return {{{0, 0}, {20, 0}, {20, 30}, {0, 30}}};
}

class FillTest : public testing::Test {
  protected:
    void SetUp() override { painting.apply(UseMedium{"soft-body acrylic"}); }
    void expect_balance() const {
        EXPECT_LT(painting.account().volume_error_rel(), kRounding);
        EXPECT_LT(painting.account().pigment_error_rel(), kRounding);
    }
    double thickness_mm(int x, int y) const {
        return film::thickness_mm(painting.film().thickness.at(x, y));
    }

    core::ThreadPool pool{2};
    Painting painting{panel_of(4.0), pool};
};

TEST_F(FillTest, AnEvenFilmCoversTheCanvas) {
    painting.apply(FillWithPaint{.paint = paint_of("PB29"), .thickness_mm = 0.25});
    for (int y = 0; y < 120; ++y)
        for (int x = 0; x < 160; ++x)
            ASSERT_EQ(thickness_mm(x, y), 0.25) << x << ", " << y;
    EXPECT_EQ(painting.account().canvas.volume_mm3, 40.0 * 30.0 * 0.25);
    EXPECT_EQ(painting.account().taken.volume_mm3, 40.0 * 30.0 * 0.25) << "to the bit";
    EXPECT_EQ(painting.account().taken.pigment, painting.account().canvas.pigment) << "to the bit";
    EXPECT_EQ(painting.undo_steps().back().step.name, "Filled with paint");
}

TEST_F(FillTest, OnlyWhatIsSelectedIsFilled) {
    painting.apply(left_half());
    painting.apply(FillWithPaint{.paint = paint_of("PB29")});
    EXPECT_GT(thickness_mm(79, 60), 0.19);
    EXPECT_EQ(thickness_mm(80, 60), 0.0);
    EXPECT_NEAR(painting.account().taken.volume_mm3, 20.0 * 30.0 * 0.2, 1e-4);
    expect_balance();
}

TEST_F(FillTest, AGradientGoesFromOnePaintToTheOther) {
    painting.apply(
        FillWithPaint{.paint = paint_of("PW6"), .second = paint_of("PB29"), .line = {{10, 5}, {30, 5}}});
    const auto cell = [&](int x, int y) { return painting.film().paint.at(x, y); };
    EXPECT_EQ(cell(0, 60), cell(39, 3));
    EXPECT_EQ(cell(120, 60), cell(159, 119));
    EXPECT_EQ(cell(90, 10), cell(90, 110)) << "the same across the line";
    for (int x = 40; x < 119; ++x) {
        const double share = (x + 0.5 - 40.0) / 80.0;
        for (int k = 0; k < film::kPigmentChannels; ++k) {
            const double wanted = (1.0 - share) * cell(0, 0)[k] + share * cell(159, 0)[k];
            // Each end was rounded, and so is the mixture.
            ASSERT_NEAR(cell(x, 60)[k], wanted, 1.5) << x << ", " << k;
        }
    }
    EXPECT_EQ(painting.account().taken.pigment, painting.account().canvas.pigment);
    expect_balance();
}

TEST_F(FillTest, AGradientTurnedAroundIsItsMirrorImage) {
    Painting turned(panel_of(4.0), pool);
    turned.apply(UseMedium{"soft-body acrylic"});
    painting.apply(FillWithPaint{
        .paint = paint_of("PW6"), .second = paint_of("PB29"), .line = {{10, 5}, {30, 12}}});
    turned.apply(FillWithPaint{
        .paint = paint_of("PW6"), .second = paint_of("PB29"), .line = {{30, 25}, {10, 18}}});
    for (int y = 0; y < 120; ++y)
        for (int x = 0; x < 160; ++x)
            for (int k = 0; k < film::kPaintChannels; ++k)
                // Places are rounded on either side of a quantum.
                ASSERT_NEAR(painting.film().paint.at(x, y)[k],
                            turned.film().paint.at(159 - x, 119 - y)[k], 1.0);
}

TEST_F(FillTest, LiesOnWetPaintAsALayerMergedOntoIt) {
    painting.apply(FillWithPaint{.paint = paint_of("PB29")});
    painting.apply(left_half());
    painting.apply(FillWithPaint{.paint = paint_of("PW6")});
    EXPECT_GT(painting.film().lower.thickness.at(10, 10), 0) << "white above blue";
    EXPECT_FALSE(painting.film().lower.thickness.at(100, 10) > 0);
    EXPECT_GT(thickness_mm(10, 10), 0.39);
    expect_balance();
    Painting merged(panel_of(4.0), pool);
    merged.apply(UseMedium{"soft-body acrylic"});
    merged.apply(FillWithPaint{.paint = paint_of("PB29")});
    merged.apply(AddLayer{"Second"});
    merged.apply(left_half());
    merged.apply(FillWithPaint{.paint = paint_of("PW6")});
    merged.apply(MergeDown{2});
    EXPECT_EQ(film::state_hash(merged.film()), film::state_hash(painting.film()));
}

TEST_F(FillTest, PaintOfAnotherMediumKeepsIt) {
    painting.apply(FillWithPaint{.paint = paint_of("PB29")});
    painting.apply(UseMedium{"heavy-body oil"});
    painting.apply(left_half());
    painting.apply(FillWithPaint{.paint = paint_of("PW6")});
    EXPECT_TRUE(painting.film().media.are_several());
    const film::FilmNumbers oil = film::film_numbers_of(film::find_medium("heavy-body oil"));
    const film::FilmNumbers acrylic = film::film_numbers_of(film::find_medium("soft-body acrylic"));
    const auto density_at = [&](int x) {
        return film::mixed_number(painting.film(), painting.film().shape.tile_at(x, 5),
                                  grid::Shape::cell_in_tile(x, 5), &film::FilmNumbers::density_kg_m3);
    };
    EXPECT_NEAR(density_at(10), 0.5 * (oil.density_kg_m3 + acrylic.density_kg_m3), 1e-6);
    EXPECT_NEAR(density_at(100), acrylic.density_kg_m3, 1e-6);
    for (int tick = 0; tick < 30; ++tick)
        painting.advance_tick();
    expect_balance();
}

TEST_F(FillTest, IsUndoneAndDoneAgainToTheBit) {
    painting.apply(FillWithPaint{.paint = paint_of("PB29")});
    const std::uint64_t first = painting.state_hash();
    painting.apply(FillWithPaint{
        .paint = paint_of("PW6"), .second = paint_of("PR108"), .line = {{0, 0}, {40, 30}}});
    const std::uint64_t second = painting.state_hash();
    const Account account = painting.account();
    painting.apply(Undo{});
    EXPECT_EQ(painting.state_hash(), first);
    expect_balance();
    painting.apply(Redo{});
    EXPECT_EQ(painting.state_hash(), second);
    EXPECT_EQ(painting.account().taken.volume_mm3, account.taken.volume_mm3);
    EXPECT_EQ(painting.account().taken.pigment, account.taken.pigment);
}

TEST_F(FillTest, AnyNumberOfThreadsGivesTheSame) {
    core::ThreadPool alone(1);
    Painting other(panel_of(4.0), alone);
    other.apply(UseMedium{"soft-body acrylic"});
    for (Painting* one : {&painting, &other}) {
        one->apply(FillWithPaint{
            .paint = paint_of("PW6"), .second = paint_of("PR108"), .line = {{0, 0}, {40, 30}}});
        one->advance_tick();
    }
    EXPECT_EQ(painting.state_hash(), other.state_hash());
}

TEST_F(FillTest, IsTheSameAtAnotherResolution) {
    Painting finer(panel_of(7.0), pool);
    finer.apply(UseMedium{"soft-body acrylic"});
    for (Painting* one : {&painting, &finer}) {
        one->apply(left_half());
        one->apply(FillWithPaint{
            .paint = paint_of("PW6"), .second = paint_of("PR108"), .line = {{0, 0}, {20, 0}}});
    }
    const Account::Amount coarse = painting.account().canvas, fine = finer.account().canvas;
    EXPECT_NEAR(fine.volume_mm3, coarse.volume_mm3, 1e-9 * coarse.volume_mm3);
    for (int k = 0; k < pigment::kChannels; ++k)
        // Cells are rounded to quanta.
        EXPECT_NEAR(fine.pigment[k], coarse.pigment[k], 1e-3 * coarse.pigment[k] + 1e-3) << k;
}

TEST_F(FillTest, MediumAloneIsPouredToo) {
    painting.apply(FillWithPaint{.thickness_mm = 0.1});
    EXPECT_GT(painting.account().canvas.volume_mm3, 119.0);
    EXPECT_EQ(painting.account().canvas.pigment[0], 0.0);
    expect_balance();
}

TEST_F(FillTest, WhatCannotBeFilledIsRefused) {
    const auto error = [&](const Action& action) { return error_of([&] { painting.apply(action); }); };
    EXPECT_EQ(error(FillWithPaint{.thickness_mm = 2.5}),
              "the thickness of the film in mm is 2.5, but must lie between 0.01 and 2.");
    EXPECT_THAT(error(FillWithPaint{.line = {{1, 1}}}), HasSubstr("number of points"));
    EXPECT_THAT(error(FillWithPaint{.line = {{1, 1}, {1, 1}}}), HasSubstr("length of the gradient"));
    EXPECT_THAT(error(FillWithPaint{.line = {{1, 1}, {1e9, 1}}}),
                HasSubstr("x of the gradient's point"));
    EXPECT_THAT(error(FillWithPaint{.paint = paint_of("no such")}), HasSubstr("no such"));
    painting.apply(SetLayer{1, {.name = "Sky", .locked = true}});
    EXPECT_THAT(error(FillWithPaint{.paint = paint_of("PB29")}), HasSubstr("\"Sky\" is locked"));
    EXPECT_EQ(painting.account().taken.volume_mm3, 0.0);
}

class ToningTest : public FillTest {
  protected:
    film::FilmState ground() const { return *painting.layers().layers[0].inactive; }
    ToneGround grey{paint_of("PBk9"), 0.1, "Ground"};
};

TEST_F(ToningTest, AnEvenDryCoatLiesBelowAllLayersOnItsOwn) {
    painting.apply(TakeBrush{"flat", 8, 1});
    painting.apply(load_of("PB29"));
    paint_wave(painting, 0.0, 10.0);
    const Account before = painting.account();
    painting.apply(grey);
    ASSERT_EQ(painting.layers().layers.size(), 2U);
    EXPECT_EQ(painting.layers().layers[0].look.name, "Ground");
    EXPECT_EQ(painting.layers().active, 1U) << "the same one is painted on";
    EXPECT_FALSE(film::has_wet_paint(ground()));
    const float relief_mm = ground().support_mm.at(0, 0);
    EXPECT_GT(relief_mm, 0.02F);
    EXPECT_LT(relief_mm, 0.1F) << "its water is gone";
    for (int y = 0; y < 120; ++y)
        for (int x = 0; x < 160; ++x) {
            ASSERT_EQ(ground().support_mm.at(x, y), relief_mm);
            ASSERT_EQ(ground().strata.optics.at(x, y), ground().strata.optics.at(0, 0));
        }
    const Account after = painting.account();
    EXPECT_EQ(after.canvas.volume_mm3, before.canvas.volume_mm3);
    EXPECT_NEAR(after.taken.volume_mm3 - before.taken.volume_mm3, 40.0 * 30.0 * 0.1, 1e-4);
    expect_balance();
    EXPECT_EQ(painting.undo_steps().back().step.name, "Ground toned");
    painting.advance_tick();
    expect_balance();
}

TEST_F(ToningTest, ItCoversWithoutRegardToTheSelectionAndUndoTakesItBack) {
    painting.apply(left_half());
    const std::uint64_t before = painting.state_hash();
    painting.apply(grey);
    EXPECT_EQ(ground().support_mm.at(159, 119), ground().support_mm.at(0, 0));
    const std::uint64_t toned = painting.state_hash();
    painting.apply(Undo{});
    EXPECT_EQ(painting.state_hash(), before);
    painting.apply(Redo{});
    EXPECT_EQ(painting.state_hash(), toned);
    painting.apply(grey);
    EXPECT_EQ(painting.layers().layers.size(), 3U) << "one upon another";
    expect_balance();
}

TEST_F(ToningTest, WhatIsSeenIsThePaint) {
    painting.apply(AddLayer{"Above"});
    painting.apply(grey);
    const film::FilmState seen = painting.snapshot().film;
    EXPECT_EQ(seen.strata.optics.at(80, 60), ground().strata.optics.at(80, 60));
    EXPECT_NE(seen.strata.optics.at(80, 60), film::kClearStrata);
}

TEST_F(ToningTest, ItIsTheSameOnFinerCells) {
    Painting finer(panel_of(7.0), pool);
    finer.apply(UseMedium{"soft-body acrylic"});
    finer.apply(grey);
    painting.apply(grey);
    const film::FilmState fine = *finer.layers().layers[0].inactive;
    EXPECT_EQ(fine.support_mm.at(3, 4), ground().support_mm.at(3, 4));
    EXPECT_EQ(fine.strata.optics.at(3, 4), ground().strata.optics.at(3, 4));
}

TEST_F(ToningTest, WhatCannotBeIsRefused) {
    grey.thickness_mm = 5.0;
    EXPECT_THAT(error_of([&] { painting.apply(grey); }), HasSubstr("thickness of the film in mm is 5"));
    grey = {paint_of("nothing"), 0.1, "Ground"};
    EXPECT_THAT(error_of([&] { painting.apply(grey); }), HasSubstr("nothing"));
    EXPECT_EQ(painting.layers().layers.size(), 1U);
}

}  // namespace
}  // namespace pastoso::document
