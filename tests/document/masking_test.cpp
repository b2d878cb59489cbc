// Neither tools nor flow nor drying reach what is masked, and tools keep off what is bare where that is
// locked.
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

MaskStripe tape(double x0_mm, double y0_mm, double x1_mm, double y1_mm, double width_mm = 5.0) {
    return {.line = {{x0_mm, y0_mm}, {x1_mm, y1_mm}}, .width_mm = width_mm, .straight_ends = true};
}

MaskStripe peeling(MaskStripe stripe) {
    stripe.peels = true;
    return stripe;
}

SelectArea box(double x0_mm, double y0_mm, double x1_mm, double y1_mm) {
    return {{{x0_mm, y0_mm}, {x1_mm, y0_mm}, {x1_mm, y1_mm}, {x0_mm, y1_mm}}};
}

FillWithPaint wash(double thickness_mm = 0.3) {
    return {.paint = {{{"PB29", 1.0}}}, .thickness_mm = thickness_mm};
}

bool same_paint(const film::FilmState& a, const film::FilmState& b, int x, int y) {
    return a.thickness.at(x, y) == b.thickness.at(x, y) && a.paint.at(x, y) == b.paint.at(x, y) &&
           a.support_mm.at(x, y) == b.support_mm.at(x, y) &&
           a.strata.optics.at(x, y) == b.strata.optics.at(x, y) &&
           a.strata.soluble_pigment.at(x, y) == b.strata.soluble_pigment.at(x, y);
}

class MaskingTest : public testing::Test {
  protected:
    void SetUp() override { prepare(painting); }
    static void prepare(Painting& fresh) {
        fresh.apply(UseMedium{"fluid acrylic"});
        fresh.apply(TakeBrush{"flat", 10, 1});
        fresh.apply(load_of("PB29"));
    }
    static std::shared_ptr<const grid::Mask> masked(const Painting& of) {
        return of.state().value.masking.cells;
    }
    static std::int64_t masked_cells(const Painting& of) {
        return masked(of) ? grid::chosen_cells(*masked(of)) : 0;
    }

    struct Changes {
        int masked = 0, free = 0;
    };
    /// Of the cells that were masked and of the others.
    static Changes changes(const film::FilmState& before, const film::FilmState& after,
                           const grid::Mask& mask) {
        Changes count;
        for (int y = 0; y < before.shape.height; ++y)
            for (int x = 0; x < before.shape.width; ++x)
                if (!same_paint(before, after, x, y)) ++(mask.at(x, y) != 0 ? count.masked : count.free);
        return count;
    }
    static void advance(Painting& of, int ticks) {
        for (int tick = 0; tick < ticks; ++tick)
            of.advance_tick();
    }
    void expect_balance() const {
        EXPECT_LT(painting.account().volume_error_rel(), kRounding);
        EXPECT_LT(painting.account().pigment_error_rel(), kRounding);
    }

    core::ThreadPool pool{2};
    Painting painting{small_canvas(), pool};
};

TEST_F(MaskingTest, NoToolReachesWhatIsMasked) {
    paint_wave(painting, 0.0, 12.0);
    painting.apply(tape(0, 12, 40, 13));
    painting.apply(MaskStripe{{{8, 8}, {9, 8.5}, {12, 16}}, 3.0});
    const grid::Mask mask = *masked(painting);
    int marks = 0;
    for (const brush::Preset& preset : brush::bundled_presets()) {
        const film::FilmState before = painting.film();
        painting.apply(TakeBrush{preset.name, 0, 3});
        painting.apply(load_of("PY35"));
        paint_wave(painting, 1.0, 14.0);
        const Changes changed = changes(before, painting.film(), mask);
        EXPECT_EQ(changed.masked, 0) << preset.name;
        marks += changed.free > 0 ? 1 : 0;
        painting.apply(Undo{});
    }
    EXPECT_GT(marks, 20);
    expect_balance();
}

TEST_F(MaskingTest, WetPaintFlowsRoundWhatIsMasked) {
    for (const char* medium : {"fluid acrylic", "thin oil", "ink glaze"}) {
        Painting fresh(small_canvas(), pool);
        fresh.apply(UseMedium{medium});
        fresh.apply(wash(1.5));
        fresh.apply(tape(5, 10, 33, 16));
        fresh.apply(MaskStripe{{{20, 25}}, 4.0});
        const film::FilmState before = fresh.film();
        fresh.apply(TiltCanvas{80, 80});
        advance(fresh, 90);
        const Changes changed = changes(before, fresh.film(), *masked(fresh));
        EXPECT_EQ(changed.masked, 0) << medium;
        EXPECT_GT(changed.free, 1000) << medium;
        EXPECT_LT(fresh.account().volume_error_rel(), kRounding) << medium;
        EXPECT_LT(fresh.account().pigment_error_rel(), kRounding) << medium;

        fresh.apply(PeelMasking{});
        advance(fresh, 30);
        EXPECT_GT(changes(before, fresh.film(), grid::Mask(before.shape)).free, changed.free)
            << "what was masked flows again: " << medium;
    }
}

TEST_F(MaskingTest, TapeHoldsBackWhatRunsDown) {
    painting.apply(tape(-5, 20, 45, 20, 3.0));
    painting.apply(box(0, 5, 40, 15));
    painting.apply(wash(1.5));
    painting.apply(SelectAll{});
    painting.apply(TiltCanvas{85, 90});
    advance(painting, 300);
    const film::FilmState& film = painting.film();
    std::int64_t above = 0, below = 0;
    for (int x = 0; x < film.shape.width; ++x) {
        above += film.thickness.at(x, 54);
        for (int y = 55; y < film.shape.height; ++y)
            below += film.thickness.at(x, y);
    }
    EXPECT_GT(above, 0) << "paint has come to the tape";
    EXPECT_EQ(below, 0);
    expect_balance();
}

TEST_F(MaskingTest, WhatIsMaskedNeitherDriesNorIsPouredOnNorCleared) {
    paint_wave(painting, 0.0, 12.0);
    painting.apply(tape(0, 12, 40, 13));
    const grid::Mask mask = *masked(painting);
    const film::FilmState before = painting.film();
    const auto expect_kept = [&](const char* what) {
        const Changes changed = changes(before, painting.film(), mask);
        EXPECT_EQ(changed.masked, 0) << what;
        EXPECT_GT(changed.free, 100) << what;
        expect_balance();
        painting.apply(Undo{});
    };
    painting.apply(DryNow{});
    expect_kept("dried at once");
    painting.apply(wash());
    expect_kept("filled");
    painting.apply(ClearLayer{1});
    expect_kept("cleared");
    painting.apply(SetDrying{{.speed = 3600.0 * 24}});
    painting.apply(box(0, 0, 1, 1));
    advance(painting, 120);
    expect_kept("dried in the air");
}

TEST_F(MaskingTest, DryPaintBelowIsDissolvedBesideTheMaskingAlone) {
    paint_dry_wave(painting);
    painting.apply(wash(0.2));
    painting.apply(tape(0, 10, 40, 10));
    const film::FilmState before = painting.film();
    advance(painting, 90);
    EXPECT_EQ(changes(before, painting.film(), *masked(painting)).masked, 0);
    expect_balance();
}

TEST_F(MaskingTest, TheWholeIsPeeledAndAPart) {
    painting.apply(tape(10, 5, 30, 5, 4.0));
    EXPECT_EQ(grid::chosen_area(*masked(painting)), (grid::Rect{30, 9, 90, 21}));
    painting.apply(peeling(tape(-5, 5, 20, 5, 100.0)));
    EXPECT_EQ(grid::chosen_area(*masked(painting)), (grid::Rect{60, 9, 90, 21}));
    painting.apply(peeling(tape(-5, 5, 50, 5, 100.0)));
    EXPECT_EQ(masked(painting), nullptr);
    painting.apply(peeling(tape(-5, 5, 50, 5, 100.0)));
    EXPECT_EQ(masked(painting), nullptr) << "where nothing is masked, nothing is peeled";
    painting.apply(MaskStripe{{{10, 10}}, 3.0});
    painting.apply(PeelMasking{});
    EXPECT_EQ(masked(painting), nullptr);
    const std::size_t steps = painting.undo_steps().size();
    painting.apply(PeelMasking{});
    painting.apply(SelectMasked{});
    painting.apply(MaskSelection{});
    EXPECT_EQ(painting.undo_steps().size(), steps) << "there was nothing to do";
}

TEST_F(MaskingTest, MaskingKeepsToTheSelection) {
    painting.apply(box(10, 0, 20, 30));
    painting.apply(tape(0, 10, 40, 10, 6.0));
    EXPECT_EQ(grid::chosen_area(*masked(painting)), (grid::Rect{30, 21, 60, 39}));
    painting.apply(box(15, 0, 40, 30));
    painting.apply(peeling(tape(0, 10, 40, 10, 6.0)));
    EXPECT_EQ(grid::chosen_area(*masked(painting)), (grid::Rect{30, 21, 45, 39}));
    const film::FilmState before = painting.film();
    paint_wave(painting, 0.0, 12.0);
    EXPECT_EQ(changes(before, painting.film(), *masked(painting)).masked, 0);
    const Selection chosen = painting.state().value.selection;
    EXPECT_EQ(changes(before, painting.film(), grid::inverted(*chosen)).masked, 0);
    EXPECT_NE(changes(before, painting.film(), *chosen).masked, 0);
}

TEST_F(MaskingTest, WhatIsSelectedIsMaskedAndTheOtherWayRound) {
    painting.apply(box(10, 0, 20, 30));
    painting.apply(MaskSelection{});
    EXPECT_EQ(grid::chosen_area(*masked(painting)), (grid::Rect{30, 0, 60, 90}));
    painting.apply(box(30, 0, 40, 30));
    painting.apply(SelectMasked{Combination::Add});
    EXPECT_EQ(grid::chosen_cells(*painting.state().value.selection), 60 * 90);
    painting.apply(MaskSelection{});
    EXPECT_EQ(masked_cells(painting), 60 * 90);
    painting.apply(SelectMasked{});
    const film::FilmState before = painting.film();
    paint_wave(painting, 0.0, 12.0);
    EXPECT_EQ(changes(before, painting.film(), *masked(painting)).free, 0)
        << "what is selected is masked: tools change nothing";
    expect_balance();
}

TEST_F(MaskingTest, UndoAndRedoGiveTheSameBits) {
    paint_wave(painting, 0.0, 8.0);
    painting.apply(TiltCanvas{60, 90});
    advance(painting, 10);
    std::vector<std::uint64_t> hashes{painting.state_hash()};
    std::vector<std::int64_t> cells{0};
    const Action steps[] = {tape(5, 3, 35, 20), wash(0.5),     peeling(tape(5, 3, 20, 12)),
                            DryNow{},           PeelMasking{}, wash(0.2)};
    for (const Action& step : steps) {
        painting.apply(step);
        hashes.push_back(painting.state_hash());
        cells.push_back(masked_cells(painting));
    }
    for (std::size_t i = std::size(steps); i-- > 0;) {
        painting.apply(Undo{});
        EXPECT_EQ(painting.state_hash(), hashes[i]) << i;
        EXPECT_EQ(masked_cells(painting), cells[i]) << i;
    }
    for (std::size_t i = 1; i <= std::size(steps); ++i) {
        painting.apply(Redo{});
        EXPECT_EQ(painting.state_hash(), hashes[i]) << i;
        EXPECT_EQ(masked_cells(painting), cells[i]) << i;
    }
    expect_balance();
}

TEST_F(MaskingTest, UndoTakesTheMaskingOffTheFlow) {
    Painting other(small_canvas(), pool);
    prepare(other);
    for (Painting* one : {&painting, &other}) {
        one->apply(wash(1.5));
        if (one == &other) {
            one->apply(tape(0, 10, 40, 10));
            one->apply(Undo{});
        }
        one->apply(TiltCanvas{80, 90});
        advance(*one, 30);
    }
    EXPECT_EQ(other.state_hash(), painting.state_hash());
}

TEST_F(MaskingTest, AnyNumberOfThreadsAndAStateTakenInBetweenGiveTheSameBits) {
    core::ThreadPool alone(1);
    Painting other(small_canvas(), alone);
    prepare(other);
    for (Painting* one : {&painting, &other}) {
        one->apply(wash(1.0));
        one->apply(tape(5, 10, 33, 16));
        one->apply(TiltCanvas{70, 60});
        advance(*one, 20);
    }
    EXPECT_EQ(painting.state_hash(), other.state_hash());
    Painting again(painting.state(), pool);
    for (Painting* one : {&painting, &again}) {
        paint_wave(*one, 1.0, 14.0);
        advance(*one, 20);
    }
    EXPECT_EQ(again.state_hash(), painting.state_hash());
    EXPECT_EQ(masked_cells(again), masked_cells(painting));
}

TEST_F(MaskingTest, FinerCellsAreMaskedAtTheSamePlace) {
    CanvasSettings fine = small_canvas();
    fine.px_per_mm *= 2.0;
    Painting other(fine, pool);
    for (Painting* one : {&painting, &other})
        one->apply(tape(10, 5, 30, 5, 4.0));
    EXPECT_EQ(masked_cells(other), 4 * masked_cells(painting));
    EXPECT_EQ(grid::chosen_area(*masked(other)), (grid::Rect{60, 18, 180, 42}));
}

TEST_F(MaskingTest, MaskingComesAlongWithTheCanvas) {
    painting.apply(tape(10, 5, 30, 5, 4.0));
    painting.apply(TurnCanvas{{true, 0}});
    EXPECT_EQ(grid::chosen_area(*masked(painting)), (grid::Rect{30, 9, 90, 21}))
        << "it is in the middle";
    painting.apply(TurnCanvas{{false, 1}});
    EXPECT_EQ(grid::chosen_area(*masked(painting)), (grid::Rect{69, 30, 81, 90}));
    painting.apply(ResizeCanvas{-10, 0, 40, 20});
    EXPECT_EQ(grid::chosen_area(*masked(painting)), (grid::Rect{99, 30, 111, 60}));
    painting.apply(ScaleCanvas{1.0, 1.0, 2.0});
    EXPECT_EQ(grid::chosen_area(*masked(painting)), (grid::Rect{198, 60, 222, 120}));
    const film::FilmState before = painting.film();
    painting.apply(wash());
    painting.apply(TiltCanvas{70, 45});
    advance(painting, 20);
    EXPECT_EQ(changes(before, painting.film(), *masked(painting)).masked, 0);
    painting.apply(ResizeCanvas{0, 0, 20, 20});
    EXPECT_EQ(masked(painting), nullptr) << "all of it was cut off";
    expect_balance();
}

TEST_F(MaskingTest, KnowsTapeFromFluid) {
    const auto taped = [&] { return painting.state().value.masking.tape; };
    painting.apply(MaskStripe{{{5, 5}, {35, 5}}, 4.0});
    EXPECT_EQ(taped(), nullptr);
    painting.apply(tape(10, 5, 30, 5, 4.0));
    EXPECT_EQ(grid::chosen_area(*taped()), (grid::Rect{30, 9, 90, 21}));
    const std::int64_t cells = masked_cells(painting);
    painting.apply(box(10, 0, 20, 30));
    painting.apply(MaskSelection{});
    EXPECT_EQ(grid::chosen_area(*taped()), (grid::Rect{60, 9, 90, 21})) << "fluid went over it";
    painting.apply(SelectAll{});
    painting.apply(TurnCanvas{{true, 0}});
    EXPECT_EQ(grid::chosen_area(*taped()), (grid::Rect{30, 9, 60, 21}));
    painting.apply(Undo{});
    painting.apply(peeling(tape(25, 5, 40, 5, 100.0)));
    EXPECT_EQ(grid::chosen_area(*taped()), (grid::Rect{60, 9, 75, 21}));
    painting.apply(ResizeCanvas{0, 0, 20, 30});
    EXPECT_EQ(taped(), nullptr) << "what is left is fluid";
    EXPECT_LT(masked_cells(painting), 60 * 90);
    EXPECT_GT(cells, 60 * 12);
    painting.apply(Undo{});
    painting.apply(PeelMasking{});
    EXPECT_EQ(taped(), nullptr);
    painting.apply(Undo{});
    EXPECT_EQ(grid::chosen_area(*taped()), (grid::Rect{60, 9, 75, 21}));
}

TEST_F(MaskingTest, AMirroredPaintingIsTheMirrorOfItsMask) {
    painting.apply(MaskStripe{{{8, 8}, {20, 20}}, 6.0});
    const grid::Mask before = *masked(painting);
    painting.apply(TurnCanvas{{true, 0}});
    const grid::Mask after = *masked(painting);
    for (int y = 0; y < before.shape().height; ++y)
        for (int x = 0; x < before.shape().width; ++x)
            ASSERT_EQ(after.at(x, y), before.at(before.shape().width - 1 - x, y)) << x << ", " << y;
}

TEST_F(MaskingTest, ItIsTheSameOnEveryLayer) {
    painting.apply(wash());
    painting.apply(tape(5, 10, 33, 16));
    painting.apply(AddLayer{"Above"});
    const film::FilmState before = painting.film();
    paint_wave(painting, 0.0, 12.0);
    painting.apply(wash());
    painting.apply(TiltCanvas{70, 45});
    advance(painting, 20);
    const Changes changed = changes(before, painting.film(), *masked(painting));
    EXPECT_EQ(changed.masked, 0);
    EXPECT_GT(changed.free, 1000);
    expect_balance();
}

class MaskedLayers : public MaskingTest {
  protected:
    /// Paint from 5 to 15 mm, a tape across it and one to the right of it.
    void SetUp() override {
        MaskingTest::SetUp();
        painting.apply(box(5, 5, 15, 25));
        painting.apply(wash());
        painting.apply(SelectAll{});
        painting.apply(tape(0, 15, 18, 15, 4.0));
        painting.apply(tape(20, 0, 20, 30, 6.0));
    }
    /// Of the active layer.
    Changes painted() {
        painting.apply(SelectPaint{});
        const grid::Mask cells = *painting.state().value.selection;
        painting.apply(Undo{});
        const grid::Mask& mask = *masked(painting);
        const std::int64_t all = grid::chosen_cells(cells);
        const std::int64_t below =
            grid::chosen_cells(grid::combined(cells, mask, Combination::Intersect));
        return {static_cast<int>(below), static_cast<int>(all - below)};
    }
    void expect_moved_off_the_tape(const Action& move) {
        const film::FilmState before = painting.film();
        const std::uint64_t hash = painting.state_hash();
        const double taken_mm3 = painting.account().taken.volume_mm3;
        const double wiped_mm3 = painting.account().ledger.volume_mm3;
        painting.apply(move);
        const Changes changed = changes(before, painting.film(), *masked(painting));
        EXPECT_EQ(changed.masked, 0) << "what lies below stays, and nothing comes there";
        EXPECT_GT(changed.free, 500);
        EXPECT_GT(painting.account().ledger.volume_mm3, wiped_mm3 + 1.0) << "it went with the tape";
        EXPECT_NEAR(painting.account().taken.volume_mm3, taken_mm3, 1e-9);
        expect_balance();
        painting.apply(Undo{});
        EXPECT_EQ(painting.state_hash(), hash);
        expect_balance();
    }
};

TEST_F(MaskedLayers, WhatIsMovedOntoTapeGoesWithIt) {
    expect_moved_off_the_tape(TransformLayer{1, {.move_x_mm = 10.0}});
}

TEST_F(MaskedLayers, TheSameOfDryPaint) {
    painting.apply(PeelMasking{});
    painting.apply(DryNow{});
    painting.apply(tape(0, 15, 18, 15, 4.0));
    painting.apply(tape(20, 0, 20, 30, 6.0));
    expect_moved_off_the_tape(TransformLayer{1, {.move_x_mm = 10.0}});
}

TEST_F(MaskedLayers, TheSameOfWhatIsSelected) {
    painting.apply(box(0, 0, 40, 14));
    expect_moved_off_the_tape(TransformLayer{1, {.move_x_mm = 10.0}});
}

TEST_F(MaskedLayers, TheSameOfWhatIsDistorted) {
    expect_moved_off_the_tape(DistortLayer{1, {{5, 5}, 10, 20, {15, 5}, {27, 6}, {26, 25}, {15, 25}}});
}

TEST_F(MaskedLayers, WhatIsPastedOntoTapeIsNotLaid) {
    painting.apply(CopyPaint{1});
    const double taken_mm3 = painting.account().taken.volume_mm3;
    painting.apply(PastePaint{"Copy", 10.0, 0.0});
    const Changes cells = painted();
    EXPECT_EQ(cells.masked, 0);
    EXPECT_GT(cells.free, 500);
    const double pasted_mm3 = painting.account().taken.volume_mm3 - taken_mm3;
    EXPECT_NEAR(pasted_mm3, cells.free * 0.3 / 9.0, 0.01 * pasted_mm3) << "the wash is 0.3 mm thick";
    expect_balance();
}

TEST_F(MaskedLayers, PicturesAndGroundsKeepOffTape) {
    const auto grey =
        std::make_shared<const pigment::Picture>(pigment::Picture{1, 1, {90, 90, 90, 255}});
    painting.apply(PaintPicture{"Photo", {0, 0, 40, 30}, grey});
    EXPECT_EQ(painted().masked, 0);
    EXPECT_GT(painted().free, 1000);
    painting.apply(ToneGround{.paint = {{{"PY35", 1.0}}}, .name = "Ground"});
    painting.apply(SelectLayer{painting.layers().layers.front().id});
    EXPECT_EQ(painted().masked, 0);
    EXPECT_GT(painted().free, 1000);
    expect_balance();
}

TEST_F(MaskedLayers, LayersAreMergedAndDuplicatedAsAWhole) {
    painting.apply(DuplicateLayer{1});
    const Changes both = painted();
    EXPECT_GT(both.masked, 100);
    painting.apply(MergeDown{painting.layers().layers.back().id});
    EXPECT_EQ(painted().masked, both.masked);
    expect_balance();
}

TEST_F(MaskingTest, WhatCannotBeMaskedIsRefused) {
    EXPECT_THAT(error_of([&] {
                    painting.apply(MaskStripe{{}, 5.0});
                }),
                HasSubstr("number of the masking"));
    EXPECT_THAT(error_of([&] {
                    painting.apply(MaskStripe{{{1, 1}}, 0.0});
                }),
                HasSubstr("width of the masking"));
    EXPECT_THAT(error_of([&] {
                    painting.apply(MaskStripe{{{1e9, 1}}, 1.0});
                }),
                HasSubstr("masking's point"));
    EXPECT_EQ(masked(painting), nullptr);
}

TEST_F(MaskingTest, WhatIsBareStaysBareWhereThatIsLocked) {
    painting.apply(box(10, 5, 30, 20));
    painting.apply(wash());
    painting.apply(SelectAll{});
    painting.apply(SetLayer{1, {.name = "Paint", .bare_locked = true}});
    const film::FilmState before = painting.film();
    grid::Mask painted(before.shape);
    for (int y = 15; y < 60; ++y)
        for (int x = 30; x < 90; ++x)
            painted.set(x, y, grid::kWhole);
    painting.apply(load_of("PY35"));
    paint_wave(painting, 0.0, 8.0);
    painting.apply(wash(0.1));
    const Changes changed = changes(before, painting.film(), painted);
    EXPECT_EQ(changed.free, 0);
    EXPECT_GT(changed.masked, 1000);
    painting.apply(tape(0, 12, 40, 12));
    const film::FilmState then = painting.film();
    paint_wave(painting, 1.0, 12.0);
    EXPECT_EQ(changes(then, painting.film(), *masked(painting)).masked, 0) << "both hold";
    EXPECT_EQ(changes(then, painting.film(), painted).free, 0);
    painting.apply(AddLayer{"Above"});
    EXPECT_FALSE(painting.layers().layers[1].look.bare_locked);
    painting.apply(SetLayer{2, {.name = "Above", .bare_locked = true}});
    const film::FilmState bare = painting.film();
    paint_wave(painting, 2.0, 20.0);
    EXPECT_EQ(changes(bare, painting.film(), grid::Mask(bare.shape)).free, 0)
        << "a bare layer stays bare";
    expect_balance();
}

TEST_F(MaskingTest, AGroupLocksWhatIsBareOfItsLayers) {
    painting.apply(GroupLayers{"Group", {1}});
    painting.apply(SetGroup{1, {.name = "Group", .bare_locked = true}});
    const film::FilmState before = painting.film();
    paint_wave(painting, 0.0, 8.0);
    EXPECT_EQ(changes(before, painting.film(), grid::Mask(before.shape)).free, 0);
}

}  // namespace
}  // namespace pastoso::document
