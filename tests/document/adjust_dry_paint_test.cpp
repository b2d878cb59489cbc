// Dry paint of a painting under glazes and with other pigments.
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

AdjustDryPaint glaze_of(const char* pigment, double thickness_mm = 0.02) {
    return {paint_of(pigment), layers::Glaze{thickness_mm}};
}

AdjustDryPaint exchange_of(const char* pigment, double share) {
    return {paint_of(pigment), layers::PaintExchange{share}};
}

SelectArea left_half() {
    return {{{0, 0}, {20, 0}, {20, 30}, {0, 30}}};
}

/// A dry blue film over the whole canvas.
void lay_dry_film(Painting& painting) {
    painting.apply(UseMedium{"soft-body acrylic"});
    painting.apply(FillWithPaint{.paint = paint_of("PB29"), .thickness_mm = 0.1});
    painting.apply(DryNow{});
}

class AdjustDryPaintTest : public testing::Test {
  protected:
    void SetUp() override { lay_dry_film(painting); }
    void expect_balance() const {
        EXPECT_LT(painting.account().volume_error_rel(), kRounding);
        EXPECT_LT(painting.account().pigment_error_rel(), kRounding);
    }
    film::StrataOptics optics(int x, int y) const { return painting.film().strata.optics.at(x, y); }
    double relief_mm(int x, int y) const {
        return painting.film().support_mm.at(x, y) - painting.snapshot().bare->support_mm.at(x, y);
    }
    std::string error(const Action& action) {
        return error_of([&] { painting.apply(action); });
    }

    core::ThreadPool pool{2};
    Painting painting{panel_of(4.0), pool};
};

TEST_F(AdjustDryPaintTest, AGlazeComesOutOfTheTubesAndItsWaterEvaporates) {
    const Account before = painting.account();
    const double relief_before_mm = relief_mm(80, 60);
    painting.apply(glaze_of("PR108"));
    const Account after = painting.account();
    const double canvas_mm2 = 40.0 * 30.0;
    // The thickness is rounded to quanta of solids, 2^-17 mm.
    EXPECT_NEAR(relief_mm(80, 60) - relief_before_mm, 0.02, 0x1p-18);
    EXPECT_NEAR(after.dried.volume_mm3 - before.dried.volume_mm3, 0.02 * canvas_mm2,
                0x1p-18 * canvas_mm2);
    const double solids = film::find_medium("soft-body acrylic").solid_fraction;
    EXPECT_NEAR(after.taken.volume_mm3 - before.taken.volume_mm3, 0.02 / solids * canvas_mm2,
                0x1p-17 / solids * canvas_mm2);
    for (int k = 0; k < pigment::kChannels; ++k)
        EXPECT_NEAR(after.taken.pigment[k] - before.taken.pigment[k],
                    after.dried.pigment[k] - before.dried.pigment[k], kRounding * after.taken.pigment[k])
            << k;
    expect_balance();
    EXPECT_EQ(painting.undo_steps().back().step.name, "Dry paint adjusted");
}

TEST_F(AdjustDryPaintTest, WhatIsExchangedIsWipedOffAndComesOutOfTheTubes) {
    const Account before = painting.account();
    const double relief_before_mm = relief_mm(80, 60);
    painting.apply(exchange_of("PR108", 0.25));
    const Account after = painting.account();
    EXPECT_EQ(relief_mm(80, 60), relief_before_mm);
    EXPECT_EQ(after.dried.volume_mm3, before.dried.volume_mm3);
    EXPECT_GT(after.taken.volume_mm3, before.taken.volume_mm3 + 0.2 * before.dried.volume_mm3);
    for (int k = 0; k < pigment::kChannels; ++k) {
        const double came = after.taken.pigment[k] - before.taken.pigment[k];
        const double went = after.ledger.pigment[k] - before.ledger.pigment[k];
        // Means over all fixed paint are rounded to quanta of the whole canvas.
        EXPECT_NEAR(went, 0.25 * before.dried.pigment[k], 1e-6 * before.dried.pigment[k] + 1e-6) << k;
        EXPECT_NEAR(after.dried.pigment[k] - before.dried.pigment[k], came - went,
                    kRounding * after.taken.pigment[k])
            << k;
    }
    expect_balance();
}

TEST_F(AdjustDryPaintTest, NothingExchangedLeavesAllAsItIs) {
    const std::uint64_t before = film::state_hash(painting.film());
    const Account account = painting.account();
    painting.apply(exchange_of("PR108", 0.0));
    EXPECT_EQ(film::state_hash(painting.film()), before);
    EXPECT_EQ(painting.account().taken.volume_mm3, account.taken.volume_mm3);
    EXPECT_EQ(painting.account().ledger.volume_mm3, account.ledger.volume_mm3);
}

TEST_F(AdjustDryPaintTest, AllOfItForTheSamePaintLooksTheSame) {
    const film::StrataOptics before = optics(80, 60);
    painting.apply(exchange_of("PB29", 1.0));
    for (std::size_t k = 0; k < before.size(); ++k)
        EXPECT_NEAR(optics(80, 60)[k], before[k], 5) << k;
    expect_balance();
}

TEST_F(AdjustDryPaintTest, WetPaintStaysAsItIsToTheBit) {
    painting.apply(TakeBrush{"flat", 8, 1});
    painting.apply(load_of("PY35"));
    paint_wave(painting, 0.0, 10.0);
    ASSERT_TRUE(film::has_wet_paint(painting.film()));
    for (const AdjustDryPaint& adjust : {glaze_of("PR108"), exchange_of("PR108", 0.5)}) {
        const film::FilmState before = painting.film();
        painting.apply(adjust);
        const film::FilmState& after = painting.film();
        for (int y = 0; y < 120; ++y)
            for (int x = 0; x < 160; ++x) {
                ASSERT_EQ(after.thickness.at(x, y), before.thickness.at(x, y));
                ASSERT_EQ(after.paint.at(x, y), before.paint.at(x, y));
                ASSERT_EQ(after.lower.thickness.at(x, y), before.lower.thickness.at(x, y));
                ASSERT_NE(after.strata.optics.at(x, y), before.strata.optics.at(x, y));
            }
    }
    for (int tick = 0; tick < 10; ++tick)
        painting.advance_tick();
    expect_balance();
}

TEST_F(AdjustDryPaintTest, KeepsToTheSelectionAndOffWhatIsMasked) {
    painting.apply(left_half());
    painting.apply(MaskStripe{{{10, 0}, {10, 30}}, 4.0, true});
    const film::StrataOptics before = optics(20, 60);
    for (const AdjustDryPaint& adjust : {glaze_of("PR108"), exchange_of("PR108", 0.5)}) {
        painting.apply(adjust);
        EXPECT_NE(optics(20, 60), before);
        EXPECT_EQ(optics(40, 60), before) << "masked";
        EXPECT_EQ(optics(79, 60), optics(20, 60));
        EXPECT_EQ(optics(80, 60), before) << "not selected";
    }
    expect_balance();
}

TEST_F(AdjustDryPaintTest, OnlyTheActiveLayerIsAdjusted) {
    painting.apply(AddLayer{"Above"});
    EXPECT_EQ(error(glaze_of("PR108")), "there is no dry paint on \"Above\" to adjust.");
    painting.apply(left_half());
    painting.apply(FillWithPaint{.paint = paint_of("PY35"), .thickness_mm = 0.1});
    painting.apply(DryNow{});
    painting.apply(SelectAll{});
    const auto below = painting.layers().layers[0].inactive;
    const double relief_before_mm = relief_mm(20, 60), bare_mm = relief_mm(120, 60);
    painting.apply(glaze_of("PR108"));
    EXPECT_EQ(painting.layers().layers[0].inactive, below);
    EXPECT_NEAR(relief_mm(20, 60) - relief_before_mm, 0.02, 0x1p-18);
    EXPECT_EQ(relief_mm(120, 60), bare_mm) << "nothing lies there on this layer";
    expect_balance();
}

TEST_F(AdjustDryPaintTest, IsUndoneAndDoneAgainToTheBit) {
    for (const AdjustDryPaint& adjust : {glaze_of("PR108"), exchange_of("PR108", 0.5)}) {
        const std::uint64_t before = painting.state_hash();
        painting.apply(adjust);
        const std::uint64_t after = painting.state_hash();
        const Account account = painting.account();
        EXPECT_NE(after, before);
        painting.apply(Undo{});
        EXPECT_EQ(painting.state_hash(), before);
        expect_balance();
        painting.apply(Redo{});
        EXPECT_EQ(painting.state_hash(), after);
        EXPECT_EQ(painting.account().taken.pigment, account.taken.pigment);
        EXPECT_EQ(painting.account().ledger.pigment, account.ledger.pigment);
    }
}

TEST_F(AdjustDryPaintTest, IsTheSameOnFinerCells) {
    Painting finer(panel_of(7.0), pool);
    lay_dry_film(finer);
    for (Painting* one : {&painting, &finer}) {
        one->apply(left_half());
        one->apply(exchange_of("PY35", 0.3));
        one->apply(glaze_of("PR108"));
    }
    for (const auto& [coarse_x, fine_x] : {std::pair(20, 35), std::pair(120, 210)}) {
        EXPECT_EQ(finer.film().strata.optics.at(fine_x, 100), optics(coarse_x, 60));
        EXPECT_EQ(
            finer.film().support_mm.at(fine_x, 100) - finer.snapshot().bare->support_mm.at(fine_x, 100),
            static_cast<float>(relief_mm(coarse_x, 60)));
    }
    const Account coarse = painting.account(), fine = finer.account();
    EXPECT_NEAR(fine.taken.volume_mm3, coarse.taken.volume_mm3, 1e-6 * coarse.taken.volume_mm3);
}

TEST_F(AdjustDryPaintTest, AnyNumberOfThreadsGivesTheSame) {
    core::ThreadPool alone(1);
    Painting other(panel_of(4.0), alone);
    lay_dry_film(other);
    for (Painting* one : {&painting, &other}) {
        one->apply(glaze_of("PR108", 0.002));
        one->apply(exchange_of("PY35", 0.3));
    }
    EXPECT_EQ(painting.state_hash(), other.state_hash());
}

TEST_F(AdjustDryPaintTest, WhatCannotBeAdjustedIsRefused) {
    const std::uint64_t before = painting.state_hash();
    EXPECT_EQ(error(glaze_of("PR108", 0.5)),
              "the thickness of the glaze in mm is 0.5, but must lie between 0.001 and 0.1.");
    EXPECT_THAT(error(exchange_of("PR108", 1.5)), HasSubstr("share of the dry paint is 1.5"));
    EXPECT_THAT(error(glaze_of("nothing")), HasSubstr("nothing"));
    EXPECT_EQ(painting.state_hash(), before);
    painting.apply(UseMedium{"thinner"});
    EXPECT_EQ(error(glaze_of("PR108")), "the medium in hand leaves next to nothing when it dries.");
    painting.apply(UseMedium{"soft-body acrylic"});
    painting.apply(SetLayer{1, {.name = "Sky", .locked = true}});
    EXPECT_THAT(error(glaze_of("PR108")), HasSubstr("\"Sky\" is locked"));
    Painting bare(panel_of(4.0), pool);
    EXPECT_EQ(error_of([&] { bare.apply(glaze_of("PR108")); }),
              "there is no dry paint on \"Paint\" to adjust.");
    EXPECT_EQ(bare.account().taken.volume_mm3, 0.0);
}

}  // namespace
}  // namespace pastoso::document
