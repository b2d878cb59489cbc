// Tools that need paint time or the waste account: rags, sprays, air, and tools of the painter's own.
#include "brush/preset.hpp"
#include "document/error_of.hpp"
#include "document/painting.hpp"
#include "document/painting_state.hpp"
#include "document/scenes.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace pastoso::document {
namespace {

using testing::HasSubstr;

constexpr double kRounding = 1e-9;

class Tools : public testing::Test {
  protected:
    core::ThreadPool pool{2};
    Painting painting{small_canvas(), pool};

    /// The pen held at a place for some ticks.
    void hold(double x_mm, double y_mm, int ticks, double tilt_x_deg = 0.0) {
        const brush::PenSample sample{
            .time_s = 0.0, .x_mm = x_mm, .y_mm = y_mm, .pressure = 1.0, .tilt_x_deg = tilt_x_deg};
        painting.apply(PenDown{sample});
        for (int tick = 0; tick < ticks; ++tick)
            painting.advance_tick();
        painting.apply(PenUp{});
    }
    void expect_balance() const {
        EXPECT_LT(painting.account().volume_error_rel(), kRounding);
        EXPECT_LT(painting.account().pigment_error_rel(), kRounding);
    }
    double canvas_mm3() const { return painting.account().canvas.volume_mm3; }
    /// Mean x of the wet paint.
    double middle_x_mm() const {
        double sum = 0.0, moment = 0.0;
        const film::FilmState& film = painting.film();
        for (int y = 0; y < film.shape.height; ++y)
            for (int x = 0; x < film.shape.width; ++x) {
                const double h = film::thickness_mm(film.thickness.at(x, y));
                sum += h;
                moment += h * (x + 0.5) * film.cell_mm;
            }
        return moment / sum;
    }
};

TEST_F(Tools, ARagTakesPaintToTheWasteAccount) {
    painting.apply(TakeBrush{"impasto flat 18", 10, 1});
    painting.apply(load_of("PB29"));
    paint_wave(painting, 0.0, 15.0);
    painting.apply(CleanBrush{});
    const Account before = painting.account();
    painting.apply(TakeBrush{"rag", 12, 1});
    painting.apply(load_of("PR254"));
    EXPECT_EQ(painting.account().taken.volume_mm3, before.taken.volume_mm3) << "a rag is not dipped";
    paint_wave(painting, 1.0, 15.0);
    const Account after = painting.account();
    EXPECT_LT(after.canvas.volume_mm3, 0.7 * before.canvas.volume_mm3);
    EXPECT_NEAR(after.ledger.volume_mm3 - before.ledger.volume_mm3,
                before.canvas.volume_mm3 - after.canvas.volume_mm3, 1e-6);
    EXPECT_EQ(after.brush.volume_mm3, 0.0);
    expect_balance();
}

TEST_F(Tools, ASprayHeldStillGoesOnSprayingUntilThePenLifts) {
    painting.apply(TakeBrush{"spray", 12, 1});
    painting.apply(load_of("PB29"));
    hold(20.0, 15.0, 60);
    const double first_mm3 = canvas_mm3();
    EXPECT_NEAR(first_mm3, brush::find_preset("spray").droplets.rate_mm3_s, 0.02 * first_mm3);
    for (int tick = 0; tick < 30; ++tick)
        painting.advance_tick();
    EXPECT_NEAR(canvas_mm3(), first_mm3, 1e-9 * first_mm3);
    expect_balance();
    painting.apply(Undo{});
    EXPECT_EQ(canvas_mm3(), 0.0);
    expect_balance();
}

/// A tick that is given up for the pen's sake leaves no drops behind.
TEST_F(Tools, AGivenUpTickLetsNothingFall) {
    painting.apply(TakeBrush{"spray", 12, 1});
    painting.apply(load_of("PB29"));
    painting.apply(PenDown{{.x_mm = 20.0, .y_mm = 15.0, .pressure = 1.0}});
    painting.advance_tick();
    const std::uint64_t hash = painting.state_hash();
    ASSERT_FALSE(painting.advance_tick_unless([] { return true; }));
    EXPECT_EQ(painting.state_hash(), hash);
}

TEST_F(Tools, AStrawBlowsPaintToWhereItLeans) {
    painting.apply(UseMedium{"ink glaze"});
    painting.apply(TakeBrush{"dropper", 0, 1});
    painting.apply(load_of("PB29"));
    hold(15.0, 15.0, 1);
    const double start_mm = middle_x_mm();
    painting.apply(TakeBrush{"blow", 0, 1});
    hold(15.0, 15.0, 20, 40.0);
    const double blown_mm = middle_x_mm();
    EXPECT_GT(blown_mm, start_mm + 0.5);
    EXPECT_EQ(painting.account().brush.volume_mm3, 0.0);
    for (int tick = 0; tick < 20; ++tick)
        painting.advance_tick();
    EXPECT_NEAR(middle_x_mm(), blown_mm, 0.5) << "the air is still again";
    expect_balance();
}

TEST_F(Tools, AToolOfThePaintersOwnComesWithItsDefinition) {
    brush::Preset own = brush::find_preset("flat");
    own.name = "Nobody else's";
    own.tip.width_mm = 7.0;
    painting.apply(TakeBrush{.preset = own.name, .definition = brush::preset_to_json(own)});
    painting.apply(load_of("PB29"));
    paint_wave(painting, 0.0, 15.0);
    EXPECT_GT(canvas_mm3(), 1.0);
    expect_balance();
}

TEST_F(Tools, ABrokenDefinitionLeavesThePreviousToolInHand) {
    painting.apply(TakeBrush{"flat", 8, 1});
    painting.apply(load_of("PB29"));
    const double held_mm3 = painting.account().brush.volume_mm3;
    EXPECT_THAT(error_of([&] {
                    painting.apply(TakeBrush{.preset = "Mine", .definition = R"({"version": 2})"});
                }),
                HasSubstr("the brush \"Mine\": kind is missing."));
    EXPECT_EQ(painting.account().brush.volume_mm3, held_mm3);
}

TEST_F(Tools, ABrushThatLiesAsideKeepsItsPaint) {
    painting.apply(TakeBrush{"impasto flat 18", 10, 1});
    painting.apply(load_of("PB29"));
    const Account before = painting.account();
    painting.apply(LayBrushAside{{"rag", 12, 1}});
    painting.apply(SwapBrushes{});
    EXPECT_EQ(painting.snapshot().brush_load.fill, 0.0);
    EXPECT_EQ(painting.account().brush.volume_mm3, before.brush.volume_mm3);
    paint_wave(painting, 0.0, 15.0);
    EXPECT_EQ(canvas_mm3(), 0.0) << "the rag has nothing to lay";
    painting.apply(SwapBrushes{});
    EXPECT_EQ(painting.account().brush.volume_mm3, before.brush.volume_mm3);
    EXPECT_EQ(painting.account().taken.volume_mm3, before.taken.volume_mm3);
    paint_wave(painting, 1.0, 15.0);
    EXPECT_GT(canvas_mm3(), 10.0);
    expect_balance();
}

TEST_F(Tools, WhatLiesAsideIsWipedWhenAnotherBrushIsLaidThere) {
    painting.apply(TakeBrush{"impasto flat 18", 10, 1});
    painting.apply(load_of("PB29"));
    const double held_mm3 = painting.account().brush.volume_mm3;
    painting.apply(LayBrushAside{{"rag", 12, 1}});
    painting.apply(SwapBrushes{});
    const double wiped_mm3 = painting.account().ledger.volume_mm3;
    painting.apply(LayBrushAside{{"rag", 20, 1}});
    EXPECT_EQ(painting.account().brush.volume_mm3, 0.0);
    EXPECT_NEAR(painting.account().ledger.volume_mm3, wiped_mm3 + held_mm3, 1e-9 * held_mm3);
    expect_balance();
}

TEST_F(Tools, WhereNoBrushLiesAsideNoneIsSwapped) {
    painting.apply(TakeBrush{"impasto flat 18", 10, 1});
    painting.apply(load_of("PB29"));
    const double held_mm3 = painting.account().brush.volume_mm3;
    painting.apply(SwapBrushes{});
    EXPECT_EQ(painting.account().brush.volume_mm3, held_mm3);
    EXPECT_EQ(painting.state().value.brush->taken.preset, "impasto flat 18");
}

}  // namespace
}  // namespace pastoso::document
