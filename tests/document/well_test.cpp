// The mixing well: paint goes from tube to well to brush to canvas and back, and none is lost.
#include "document/error_of.hpp"
#include "document/well_session.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace pastoso::document {
namespace {

using testing::HasSubstr;

/// Paint is moved in whole quanta and in doubles, so that only their rounding is left.
constexpr double kRounding = 1e-12;

class WellTest : public testing::Test {
  protected:
    core::ThreadPool pool{2};
    Painting painting{small_canvas(), pool};

    void take_brush() { painting.apply(TakeBrush{"flat", 8, 1}); }
    void stroke(Surface surface, double x0_mm, double x1_mm, double y_mm) {
        apply_all(painting, line_on(surface, next_s_, x0_mm, x1_mm, y_mm));
        next_s_ += 1.0;
    }
    void advance(int ticks) {
        for (int i = 0; i < ticks; ++i)
            painting.advance_tick();
    }
    void expect_balance() const {
        EXPECT_LT(painting.account().volume_error_rel(), kRounding);
        EXPECT_LT(painting.account().pigment_error_rel(), kRounding);
    }
    double well_mm3() const { return painting.account().well.volume_mm3; }
    double brush_mm3() const { return painting.account().brush.volume_mm3; }
    double canvas_mm3() const { return painting.account().canvas.volume_mm3; }

  private:
    double next_s_ = 0.0;
};

TEST_F(WellTest, CostsNothingUntilItIsTouched) {
    take_brush();
    painting.apply(load_of("PB29"));
    stroke(Surface::Canvas, 5, 30, 10);
    painting.apply(CleanWell{});
    advance(5);
    EXPECT_EQ(painting.well(), nullptr);
    EXPECT_FALSE(painting.snapshot().well.has_value());
    EXPECT_EQ(painting.state_hash(), film::state_hash(painting.film()));
    painting.apply(Undo{});
    EXPECT_EQ(canvas_mm3(), 0.0) << "cleaning a bare well is nothing to undo";
}

TEST_F(WellTest, ABareWellHoldsNoTiles) {
    const film::FilmState bare = bare_well();
    EXPECT_EQ(bare.shape, (grid::Shape{360, 270}));
    EXPECT_EQ(bare.thickness.allocated_bytes() + bare.paint.allocated_bytes() +
                  bare.support_mm.allocated_bytes() + bare.velocity_x.allocated_bytes() +
                  bare.strata.optics.allocated_bytes(),
              0U);
}

TEST_F(WellTest, SqueezedPaintComesOutOfTheTube) {
    painting.apply(squeeze_of("PB29", 30, 40, 300));
    const Account account = painting.account();
    EXPECT_NEAR(account.taken.volume_mm3, 300.0, 0.01);
    EXPECT_NEAR(account.well.volume_mm3, account.taken.volume_mm3, 1e-9);
    EXPECT_EQ(account.canvas.volume_mm3, 0.0);
    expect_balance();
    ASSERT_NE(painting.well(), nullptr);
    EXPECT_GT(film::thickness_mm(painting.well()->thickness.at(90, 120)), 1.0F);
    EXPECT_EQ(painting.well()->thickness.at(180, 120), 0);
}

TEST_F(WellTest, PaintAtTheRimStaysInTheWell) {
    painting.apply(UseMedium{"ink glaze"});
    painting.apply(squeeze_of("PB29", 0, 0, 900));
    const double squeezed_mm3 = well_mm3();
    EXPECT_NEAR(squeezed_mm3, 900.0, 0.01);
    advance(60);
    EXPECT_NEAR(well_mm3(), squeezed_mm3, 1e-9);
    EXPECT_EQ(painting.account().ledger.volume_mm3, 0.0);
    expect_balance();
}

TEST_F(WellTest, WhatAPlaceHasNoRoomForStaysInTheTube) {
    for (int i = 0; i < 12; ++i)
        painting.apply(squeeze_of("PW6", 60, 45, 5000));
    EXPECT_LT(well_mm3(), 12 * 5000.0);
    EXPECT_NEAR(painting.account().taken.volume_mm3, well_mm3(), 1e-6);
    expect_balance();
}

TEST_F(WellTest, AnEmptyBrushPicksUpAndCarriesToTheCanvas) {
    painting.apply(squeeze_of("PR108", 30, 40, 600));
    take_brush();
    stroke(Surface::Well, 20, 40, 40);
    const double picked_mm3 = brush_mm3();
    EXPECT_GT(picked_mm3, 20.0);
    EXPECT_NEAR(well_mm3() + picked_mm3, painting.account().taken.volume_mm3, 1e-9);
    stroke(Surface::Canvas, 8, 32, 15);
    EXPECT_GT(canvas_mm3(), 20.0);
    EXPECT_LT(brush_mm3(), picked_mm3);
    expect_balance();
}

TEST_F(WellTest, ADirtyBrushSoilsTheWell) {
    painting.apply(squeeze_of("PW6", 30, 40, 600));
    take_brush();
    painting.apply(load_of("PB29"));
    const Account::Amount white = painting.account().well;
    stroke(Surface::Well, 20, 40, 40);
    // Ultramarine absorbs red (K of band 5) and titanium white does not.
    EXPECT_GT(painting.account().well.pigment[5], 10.0 * white.pigment[5]);
    expect_balance();
}

TEST_F(WellTest, TheAccountBalancesOverMixedStrokes) {
    for (const Event& event : mixing_session().events) {
        while (painting.tick() < event.tick)
            painting.advance_tick();
        painting.apply(event.action);
        expect_balance();
    }
    EXPECT_GT(canvas_mm3(), 5.0);
    painting.apply(CleanBrush{});
    painting.apply(DryNow{});
    expect_balance();
    painting.apply(CleanWell{});
    expect_balance();
    EXPECT_EQ(well_mm3(), 0.0);
    EXPECT_EQ(painting.well(), nullptr);
    const Account account = painting.account();
    EXPECT_NEAR(account.taken.volume_mm3, account.dried.volume_mm3 + account.ledger.volume_mm3, 1e-9);
}

TEST_F(WellTest, UndoAndRedoIncludeTheWell) {
    std::vector<std::uint64_t> hashes = {painting.state_hash()};
    const auto note = [&] { hashes.push_back(painting.state_hash()); };
    take_brush();
    painting.apply(squeeze_of("PY35", 30, 40));
    note();
    stroke(Surface::Well, 20, 40, 40);
    note();
    stroke(Surface::Canvas, 8, 32, 15);
    note();
    painting.apply(CleanWell{});
    note();
    for (auto hash = hashes.rbegin() + 1; hash != hashes.rend(); ++hash) {
        painting.apply(Undo{});
        EXPECT_EQ(painting.state_hash(), *hash);
        expect_balance();
    }
    EXPECT_EQ(painting.well(), nullptr);
    EXPECT_EQ(brush_mm3(), 0.0);
    EXPECT_EQ(painting.account().taken.volume_mm3, 0.0);
    for (auto hash = hashes.begin() + 1; hash != hashes.end(); ++hash) {
        painting.apply(Redo{});
        EXPECT_EQ(painting.state_hash(), *hash);
        expect_balance();
    }
}

SqueezePaint joined(SqueezePaint squeeze) {
    squeeze.joins = true;
    return squeeze;
}

TEST_F(WellTest, WhatIsSqueezedOutTogetherIsOneStep) {
    painting.apply(squeeze_of("PY35", 30, 40));
    const std::uint64_t one = painting.state_hash();
    painting.apply(squeeze_of("PB29", 60, 20));
    painting.apply(joined(squeeze_of("PW6", 60, 45)));
    painting.apply(joined(squeeze_of("PR108", 60, 70)));
    const std::uint64_t all = painting.state_hash();
    EXPECT_EQ(painting.undo_steps().size(), 2U);
    painting.apply(Undo{});
    EXPECT_EQ(painting.state_hash(), one);
    expect_balance();
    painting.apply(Redo{});
    EXPECT_EQ(painting.state_hash(), all);
    expect_balance();
    painting.apply(Undo{});
    painting.apply(joined(squeeze_of("PW6", 60, 45)));
    EXPECT_FALSE(painting.can_redo()) << "that would lose what joined";
    EXPECT_EQ(painting.undo_steps().size(), 2U) << "it did not come right after the one before";
    painting.apply(Undo{});
    EXPECT_EQ(painting.state_hash(), one);
}

/// A recording does not have it.
TEST_F(WellTest, WhatWasRefusedIsAsIfItHadNotBeen) {
    painting.apply(squeeze_of("PY35", 30, 40));
    EXPECT_THROW(painting.apply(squeeze_of("PX99", 60, 20)), core::InputError);
    painting.apply(joined(squeeze_of("PW6", 60, 45)));
    EXPECT_EQ(painting.undo_steps().size(), 1U);
}

TEST_F(WellTest, WhatJoinsNothingOfItsKindIsAStepOfItsOwn) {
    painting.apply(joined(squeeze_of("PY35", 30, 40)));
    EXPECT_EQ(painting.undo_steps().size(), 1U);
    painting.apply(DryNow{});
    painting.apply(joined(squeeze_of("PW6", 60, 45)));
    EXPECT_EQ(painting.undo_steps().size(), 3U);
    EXPECT_GT(well_mm3(), 1.0);
    expect_balance();
}

TEST_F(WellTest, UndoOnTheWellKeepsABrushThatWasTakenSince) {
    painting.apply(squeeze_of("PY35", 30, 40));
    take_brush();
    stroke(Surface::Well, 20, 40, 40);
    take_brush();
    painting.apply(load_of("PB29"));
    const double loaded_mm3 = brush_mm3();
    painting.apply(Undo{});
    EXPECT_EQ(brush_mm3(), loaded_mm3);
    expect_balance();
    painting.apply(Undo{});
    EXPECT_EQ(well_mm3(), 0.0);
    expect_balance();
}

TEST_F(WellTest, LiesFlatAndStaysOpenWhateverTheCanvasDoes) {
    painting.apply(UseMedium{"house paint"});
    painting.apply(squeeze_of("PB29", 60, 45, 600));
    Painting other(small_canvas(), pool);
    other.apply(UseMedium{"house paint"});
    other.apply(squeeze_of("PB29", 60, 45, 600));
    painting.apply(TiltCanvas{90, 90});
    painting.apply(SetDrying{{.speed = 1e5}});
    painting.apply(DryNow{});
    for (int i = 0; i < 90; ++i) {
        painting.advance_tick();
        other.advance_tick();
    }
    EXPECT_EQ(film::state_hash(*painting.well()), film::state_hash(*other.well()));
}

TEST_F(WellTest, GuidesAndSymmetryLieOnTheCanvas) {
    const auto painted = [&](bool aids) {
        Painting one(small_canvas(), pool);
        if (aids) {
            one.apply(SetGuide{{.form = brush::Ruler{0, 0, 40, 30}}});
            one.apply(SetSymmetry{{.centre_x_mm = 20, .centre_y_mm = 15, .mirror = true, .count = 3}});
        }
        one.apply(TakeBrush{"flat", 8, 1});
        one.apply(load_of("PB29"));
        apply_all(one, line_on(Surface::Well, 0.0, 20, 40, 16));
        return film::state_hash(*one.well());
    };
    EXPECT_EQ(painted(true), painted(false));
}

TEST_F(WellTest, AnotherMediumIsCarriedAsItIs) {
    painting.apply(UseMedium{"ink glaze"});
    painting.apply(squeeze_of("PB29", 30, 40));
    take_brush();
    stroke(Surface::Well, 20, 40, 40);
    painting.apply(UseMedium{"heavy-body oil"});
    stroke(Surface::Canvas, 8, 32, 15);
    EXPECT_TRUE(painting.film().consistencies.are_several());
    EXPECT_TRUE(painting.well()->consistencies.are_several());
    advance(10);
    expect_balance();
}

TEST_F(WellTest, DropsFallIntoTheWellAndAirMovesThem) {
    painting.apply(UseMedium{"ink glaze"});
    painting.apply(TakeBrush{"dropper", 0, 1});
    painting.apply(load_of("PB29"));
    painting.apply(PenDown{{0, 60, 45, 1.0}, Surface::Well});
    advance(10);
    painting.apply(PenUp{});
    EXPECT_GT(well_mm3(), 0.0);
    EXPECT_EQ(canvas_mm3(), 0.0);
    expect_balance();
    advance(120);
    painting.apply(TakeBrush{"blow", 0, 1});
    const std::uint64_t before = film::state_hash(*painting.well());
    painting.apply(PenDown{{3, 58, 45, 1.0, 40.0}, Surface::Well});
    advance(20);
    painting.apply(PenUp{});
    EXPECT_NE(film::state_hash(*painting.well()), before);
    expect_balance();
}

TEST_F(WellTest, RefusesWhatMakesNoSense) {
    EXPECT_EQ(error_of([&] {
                  painting.apply(PenDown{{0, 1, 1, 0.5}, Surface::Well});
              }),
              "the pen touches the mixing well with no brush in hand.");
    EXPECT_EQ(error_of([&] { painting.apply(squeeze_of("PB29", 121, 5)); }),
              "the x of the squeezed paint in mm is 121, but must lie between 0 and 120.");
    EXPECT_THAT(error_of([&] { painting.apply(squeeze_of("PB29", NAN, 5)); }), HasSubstr("nan"));
    EXPECT_THAT(error_of([&] { painting.apply(squeeze_of("XX9", 5, 5)); }), HasSubstr("XX9"));
    EXPECT_THAT(error_of([&] { painting.apply(squeeze_of("PB29", 5, 5, 0.0)); }),
                HasSubstr("volume of the squeezed paint in mm3 is 0"));
    EXPECT_EQ(painting.well(), nullptr);
    EXPECT_FALSE(painting.can_undo());
}

}  // namespace
}  // namespace pastoso::document
