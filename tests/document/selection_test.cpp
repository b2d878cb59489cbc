// Tools change nothing but what is selected.
#include "brush/preset.hpp"
#include "document/error_of.hpp"
#include "document/painting.hpp"
#include "document/painting_state.hpp"
#include "document/scenes.hpp"

#include <functional>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace pastoso::document {
namespace {

using testing::HasSubstr;

constexpr double kRounding = 1e-9;

/// A rectangle of the canvas of small_canvas(), which is 40 x 30 mm.
SelectArea rectangle(double x0_mm, double y0_mm, double x1_mm, double y1_mm,
                     Combination how = Combination::Replace) {
    return {{{x0_mm, y0_mm}, {x1_mm, y0_mm}, {x1_mm, y1_mm}, {x0_mm, y1_mm}}, how};
}

class SelectionTest : public testing::Test {
  protected:
    void SetUp() override {
        painting.apply(UseMedium{"soft-body acrylic"});
        painting.apply(TakeBrush{"flat", 10, 1});
        painting.apply(load_of("PB29"));
    }
    Selection selection() const { return painting.state().value.selection; }
    std::int64_t selected() const { return selection() ? grid::chosen_cells(*selection()) : -1; }

    /// Cells of the canvas on which two states differ, and that lie where `where` says.
    static int differing(const film::FilmState& a, const film::FilmState& b,
                         const std::function<bool(int x, int y)>& where) {
        int count = 0;
        for (int y = 0; y < a.shape.height; ++y)
            for (int x = 0; x < a.shape.width; ++x)
                if (where(x, y) && (a.thickness.at(x, y) != b.thickness.at(x, y) ||
                                    a.paint.at(x, y) != b.paint.at(x, y) ||
                                    a.velocity_x.at(x, y) != b.velocity_x.at(x, y) ||
                                    a.velocity_y.at(x, y) != b.velocity_y.at(x, y) ||
                                    a.support_mm.at(x, y) != b.support_mm.at(x, y) ||
                                    a.strata.optics.at(x, y) != b.strata.optics.at(x, y)))
                    ++count;
        return count;
    }
    void expect_balance() const {
        EXPECT_LT(painting.account().volume_error_rel(), kRounding);
        EXPECT_LT(painting.account().pigment_error_rel(), kRounding);
    }

    core::ThreadPool pool{2};
    Painting painting{small_canvas(), pool};
};

TEST_F(SelectionTest, NoToolChangesWhatIsNotSelected) {
    paint_wave(painting, 0.0, 12.0);
    painting.apply(rectangle(12, 5, 25, 25));
    const Selection chosen = selection();
    const auto is_chosen = [&](int x, int y) { return chosen->at(x, y) != 0; };
    const auto is_left = [&](int x, int y) { return chosen->at(x, y) == 0; };
    int marks = 0;
    for (const brush::Preset& preset : brush::bundled_presets()) {
        const film::FilmState before = painting.film();
        painting.apply(TakeBrush{preset.name, 0, 3});
        painting.apply(load_of("PY35"));
        paint_wave(painting, 1.0, 14.0);
        EXPECT_EQ(differing(before, painting.film(), is_left), 0) << preset.name;
        marks += differing(before, painting.film(), is_chosen) > 0 ? 1 : 0;
        painting.apply(Undo{});
    }
    EXPECT_GT(marks, 20);
    expect_balance();
}

TEST_F(SelectionTest, InsideTheMarkIsThatOfTheWholeStroke) {
    painting.apply(rectangle(0, 0, 40, 30));
    paint_wave(painting, 0.0, 12.0);
    const std::uint64_t all_selected = painting.state_hash();
    painting.apply(Undo{});
    painting.apply(SelectAll{});
    EXPECT_EQ(selected(), -1);
    paint_wave(painting, 0.0, 12.0);
    EXPECT_EQ(painting.state_hash(), all_selected);
}

TEST_F(SelectionTest, AirBlowsWhereTheJetIsOnTheSelection) {
    const auto blown_at = [&](double x_mm) {
        Painting fresh(small_canvas(), pool);
        fresh.apply(TakeBrush{"flat", 10, 1});
        fresh.apply(load_of("PB29"));
        paint_wave(fresh, 0.0, 12.0);
        fresh.apply(rectangle(0, 0, 12, 30));
        fresh.apply(TakeBrush{"Straw 8", 0, 1});
        fresh.apply(PenDown{{.x_mm = x_mm, .y_mm = 12.0, .pressure = 1.0}});
        for (int tick = 0; tick < 10; ++tick)
            fresh.advance_tick();
        fresh.apply(PenUp{});
        return fresh.state_hash();
    };
    const std::uint64_t beside = blown_at(30.0);
    EXPECT_EQ(blown_at(25.0), beside);
    EXPECT_NE(blown_at(8.0), beside);
}

TEST_F(SelectionTest, OnlyWhatIsSelectedDriesAtOnce) {
    paint_wave(painting, 0.0, 12.0);
    painting.apply(rectangle(0, 0, 20, 30));
    const film::FilmState wet = painting.film();
    painting.apply(DryNow{});
    const film::FilmState& film = painting.film();
    for (int y = 0; y < film.shape.height; ++y)
        for (int x = 0; x < film.shape.width; ++x)
            ASSERT_EQ(film.thickness.at(x, y), x < 60 ? 0 : wet.thickness.at(x, y)) << x << ", " << y;
    EXPECT_GT(film.strata.fixed.thickness, 0);
    expect_balance();
}

TEST_F(SelectionTest, WhatIsHighAndWhatIsWetIsFound) {
    paint_wave(painting, 0.0, 12.0);
    painting.apply(SelectByWetness{0.1, 100.0});
    const film::FilmState film = painting.film();
    for (int y = 0; y < film.shape.height; ++y)
        for (int x = 0; x < film.shape.width; ++x)
            ASSERT_EQ(selection()->at(x, y) != 0, film::thickness_mm(film.thickness.at(x, y)) >= 0.1);
    const std::int64_t wet = selected();
    painting.apply(SelectByHeight{0.1, 100.0});
    EXPECT_EQ(selected(), wet);
    painting.apply(DryNow{});
    painting.apply(SelectByWetness{0.1, 100.0});
    EXPECT_EQ(selected(), -1);
    painting.apply(SelectByHeight{0.03, 100.0});
    EXPECT_GT(selected(), 100);
}

TEST_F(SelectionTest, ClearingWipesOffWhatIsSelected) {
    paint_wave(painting, 0.0, 12.0);
    painting.apply(DryNow{});
    paint_wave(painting, 1.0, 13.0);
    const film::FilmState before = painting.film();
    painting.apply(rectangle(0, 0, 20, 30));
    const Selection chosen = selection();
    painting.apply(ClearLayer{1});
    EXPECT_EQ(differing(before, painting.film(), [&](int x, int y) { return chosen->at(x, y) == 0; }),
              0);
    const film::FilmState bare = Painting(small_canvas(), pool).film();
    EXPECT_EQ(differing(bare, painting.film(), [&](int x, int y) { return chosen->at(x, y) != 0; }), 0);
    expect_balance();
    painting.apply(Undo{});
    EXPECT_EQ(film::state_hash(painting.film()), film::state_hash(before));
}

TEST_F(SelectionTest, WhatIsSelectedMovesAndTheSelectionWithIt) {
    painting.apply(TakeBrush{"flat", 4, 1});
    painting.apply(load_of("PB29"));
    paint_wave(painting, 0.0, 8.0);
    const film::FilmState before = painting.film();
    painting.apply(rectangle(0, 0, 20, 14));
    painting.apply(TransformLayer{1, {.move_y_mm = 15.0}});
    const film::FilmState& film = painting.film();
    for (int y = 0; y < 45; ++y)
        for (int x = 0; x < 120; ++x) {
            ASSERT_EQ(film.thickness.at(x, y), x < 60 ? 0 : before.thickness.at(x, y));
            if (x < 60) {
                ASSERT_EQ(film.thickness.at(x, y + 45), before.thickness.at(x, y));
            }
        }
    EXPECT_EQ(grid::chosen_area(*selection()), (grid::Rect{0, 45, 60, 87}));
    expect_balance();
    painting.apply(
        TransformLayer{1, {.centre_x_mm = 10, .centre_y_mm = 22, .turn_deg = 40, .scale_x = 1.5}});
    expect_balance();
    EXPECT_GT(painting.account().taken.volume_mm3, 0.0);
    painting.apply(SelectAll{});
    painting.apply(TransformLayer{1, {.move_x_mm = 1000}});
    EXPECT_EQ(painting.account().canvas.volume_mm3, 0.0);
    expect_balance();
}

TEST_F(SelectionTest, LockedLayersStayWhereTheyAre) {
    painting.apply(SetLayer{1, {.name = "Sky", .locked = true}});
    EXPECT_THAT(error_of([&] {
                    painting.apply(TransformLayer{1, {.move_x_mm = 3}});
                }),
                HasSubstr("\"Sky\" is locked"));
    EXPECT_THAT(error_of([&] {
                    painting.apply(TransformLayer{1, {.scale_x = 0.0}});
                }),
                HasSubstr("scale of the transform along x"));
}

TEST_F(SelectionTest, SelectionsCombineAndAreUndone) {
    painting.apply(rectangle(0, 0, 10, 10));
    EXPECT_EQ(selected(), 30 * 30);
    painting.apply(rectangle(5, 0, 20, 10, Combination::Add));
    EXPECT_EQ(selected(), 60 * 30);
    painting.apply(rectangle(0, 0, 40, 5, Combination::Subtract));
    EXPECT_EQ(selected(), 60 * 15);
    painting.apply(rectangle(0, 0, 10, 30, Combination::Intersect));
    EXPECT_EQ(selected(), 30 * 15);
    painting.apply(InvertSelection{});
    EXPECT_EQ(selected(), 120 * 90 - 30 * 15);
    painting.apply(Undo{});
    painting.apply(Undo{});
    EXPECT_EQ(selected(), 60 * 15);
    painting.apply(Redo{});
    EXPECT_EQ(selected(), 30 * 15);
}

TEST_F(SelectionTest, WithoutASelectionEverythingIsSelected) {
    painting.apply(InvertSelection{});
    painting.apply(SelectAll{});
    EXPECT_FALSE(painting.can_undo());
    painting.apply(rectangle(0, 0, 10, 10, Combination::Subtract));
    EXPECT_EQ(selected(), 120 * 90 - 30 * 30);
    painting.apply(rectangle(0, 0, 10, 10, Combination::Intersect));
    EXPECT_EQ(selected(), -1);
    painting.apply(rectangle(0, 0, 10, 10, Combination::Intersect));
    EXPECT_EQ(selected(), 30 * 30);
    painting.apply(rectangle(50, 0, 60, 10));
    EXPECT_EQ(selected(), -1);
}

TEST_F(SelectionTest, TheWellIsFree) {
    painting.apply(rectangle(0, 0, 1, 1));
    painting.apply(PenDown{{.x_mm = 60, .y_mm = 45, .pressure = 1.0}, Surface::Well});
    painting.apply(PenMove{{.time_s = 0.2, .x_mm = 70, .y_mm = 45, .pressure = 1.0}});
    painting.apply(PenUp{});
    EXPECT_GT(painting.account().well.volume_mm3, 0.0);
    EXPECT_EQ(painting.account().canvas.volume_mm3, 0.0);
}

TEST_F(SelectionTest, WhatCannotBeSelectedIsRefused) {
    const auto error = [&](const Action& action) { return error_of([&] { painting.apply(action); }); };
    EXPECT_EQ(error(SelectArea{{{1, 1}, {2, 2}}}),
              "the number of the outline's points is 2, but must lie between 3 and 20000.");
    EXPECT_THAT(error(SelectArea{{{1, 1}, {2, 2}, {3, 1e9}}}), HasSubstr("y of the outline's point"));
    EXPECT_THAT(error(SelectByHeight{2.0, 1.0}), HasSubstr("most height in mm"));
    EXPECT_THAT(error(SelectByWetness{-1.0, 1.0}), HasSubstr("least thickness of wet paint"));
    EXPECT_EQ(selected(), -1);
}

}  // namespace
}  // namespace pastoso::document
