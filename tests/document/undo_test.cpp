// Undo and Redo of a whole painting: with packing and without, wet, dried and at rest.
#include "core/random.hpp"
#include "document/painting.hpp"
#include "document/painting_state.hpp"
#include "document/player.hpp"
#include "document/scenes.hpp"

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

namespace pastoso::document {
namespace {

/// Too little for one step of these paintings as it is, so that all but the last are packed.
constexpr std::size_t kTightBudget_bytes = std::size_t{2} << 20;

/// Of the account, as sums of many cells have it.
constexpr double kRounding = 1e-9;

void advance(Painting& painting, int ticks) {
    for (int i = 0; i < ticks; ++i)
        painting.advance_tick();
}

/// Changes a layer or takes another one, as far as there are such.
void change_layers(Painting& painting, std::uint32_t number) {
    const LayerStack stack = painting.state().value.layers;
    const std::vector<Layer>& layers = stack.layers;
    const LayerId layer = layers[core::scramble(number + 3) % layers.size()].id;
    const auto choice = core::scramble(number + 4) % 8;
    if (choice < 2 && layers.size() < 5)
        painting.apply(AddLayer{"More"});
    else if (choice == 2)
        painting.apply(SetLayer{layer, {.name = "Faded", .opacity = 0.5}});
    else if (choice == 3)
        painting.apply(DuplicateLayer{layer});
    else if (choice == 4 && layers.size() > 1)
        painting.apply(RemoveLayer{layer});
    else if (choice == 5 && layer != layers.front().id)
        painting.apply(MergeDown{layer});
    else
        painting.apply(SelectLayer{layer});
}

/// Dips the brush in hand, or takes the one that lies aside.
void change_brushes(Painting& painting, std::uint32_t number) {
    const auto choice = core::scramble(number + 3) % 4;
    if (choice == 0) painting.apply(LayBrushAside{{"round sable 9", 6, number}});
    if (choice < 2)
        painting.apply(SwapBrushes{});
    else
        painting.apply(load_of(number % 2 == 0 ? "PB29" : "PR254"));
}

/// One of the things that painters do, chosen by a number.
void do_something(Painting& painting, std::uint32_t number) {
    const auto choice = core::scramble(number) % 20;
    if (choice < 4)
        painting.apply(Undo{});
    else if (choice < 6)
        painting.apply(Redo{});
    else if (choice == 6)
        painting.apply(DryNow{});
    else if (choice == 7)
        painting.apply(SqueezePaint{load_of("PY35").paint, 50.0, 20.0, 30.0});
    else if (choice == 8)
        painting.apply(CleanWell{});
    else if (choice == 9)
        change_brushes(painting, number);
    else if (choice < 14)
        change_layers(painting, number);
    else
        paint_wave(painting, number, 4.0 + core::scramble(number + 1) % 22);
    advance(painting, static_cast<int>(core::scramble(number + 2) % 3));
}

TEST(PaintingUndo, ARandomSessionIsTheSameWithPackingAndWithout) {
    core::ThreadPool pool(2);
    Painting plain(small_canvas(), pool), packed(small_canvas(), pool);
    plain.set_history_budget(std::size_t{4} << 30);
    packed.set_history_budget(kTightBudget_bytes * 8);
    for (Painting* painting : {&plain, &packed}) {
        painting->apply(TakeBrush{"flat", 8, 1});
        painting->apply(load_of("PB29"));
    }
    bool any_packed = false;
    for (std::uint32_t number = 0; number < 90; ++number) {
        do_something(plain, number);
        do_something(packed, number);
        ASSERT_EQ(plain.state_hash(), packed.state_hash()) << "after step " << number;
        ASSERT_EQ(plain.can_undo(), packed.can_undo());
        const auto steps = packed.undo_steps();
        any_packed = any_packed || std::any_of(steps.begin(), steps.end(),
                                               [](const KeptStep& step) { return step.packed; });
    }
    EXPECT_TRUE(any_packed);
}

TEST(PaintingUndo, TheDepthOfARecordingIsHowFarItGoesBack) {
    const PenDown stroke{};
    const auto depth = [](std::vector<Action> actions) {
        Recording recording;
        for (Action& action : actions)
            recording.events.push_back({0, std::move(action)});
        return undo_depth(recording);
    };
    EXPECT_EQ(depth({stroke, stroke}), 0U);
    EXPECT_EQ(depth({stroke, Undo{}}), 1U);
    EXPECT_EQ(depth({stroke, stroke, Undo{}, Redo{}, Undo{}}), 1U);
    const PenDown beside{.sample = {}, .beside = true};
    EXPECT_EQ(depth({stroke, stroke, Undo{}, beside, Undo{}}), 2U) << "it may be none";
    SqueezePaint joined;
    joined.joins = true;
    EXPECT_EQ(depth({stroke, stroke, Undo{}, joined, Undo{}}), 2U);
    EXPECT_EQ(depth({stroke, stroke, stroke, Undo{}, Undo{}, stroke, Undo{}, Undo{}}), 3U);
}

TEST(PaintingUndo, AReplayFollowsAPaintingOfAnyBudget) {
    constexpr int kStrokes = 12, kUndone = 8;
    core::ThreadPool pool(2);
    Painting painting(small_canvas(), pool), replay(small_canvas(), pool), tight(small_canvas(), pool);
    painting.set_history_budget(std::size_t{4} << 30);
    tight.set_history_budget(kTightBudget_bytes / 64);
    replay.set_history_budget(kTightBudget_bytes / 64);
    replay.keep_undo_steps(kUndone);
    for (Painting* one : {&painting, &replay, &tight}) {
        one->apply(TakeBrush{"flat", 8, 1});
        one->apply(load_of("PB29"));
        for (int stroke = 0; stroke < kStrokes; ++stroke)
            paint_wave(*one, stroke, 4.0 + stroke);
        EXPECT_LE(replay.undo_steps().size(), std::size_t{kUndone});
        for (int undone = 0; undone < kUndone; ++undone)
            one->apply(Undo{});
    }
    EXPECT_EQ(replay.state_hash(), painting.state_hash());
    EXPECT_NE(tight.state_hash(), painting.state_hash());
}

TEST(PaintingUndo, TellsWhatItTakesBack) {
    core::ThreadPool pool(1);
    Painting painting(small_canvas(), pool);
    painting.apply(TakeBrush{"flat", 8, 1});
    painting.apply(load_of("PB29"));
    paint_wave(painting, 0.0, 10.0);
    painting.apply(DryNow{});
    painting.apply(SqueezePaint{load_of("PY35").paint, 50.0, 20.0, 30.0});
    painting.apply(CleanWell{});
    painting.apply(Undo{});
    const auto steps = painting.undo_steps();
    ASSERT_EQ(steps.size(), 3U);
    EXPECT_EQ(steps[0].step.name, "Stroke");
    EXPECT_FALSE(steps[0].step.brush.empty());
    EXPECT_EQ(steps[1].step.name, "Dry now");
    EXPECT_GT(steps[1].bytes, 0U);
    EXPECT_EQ(steps[2].step.name, "Paint squeezed out");
    ASSERT_EQ(painting.redo_steps().size(), 1U);
    EXPECT_EQ(painting.redo_steps()[0].step.name, "Mixing well wiped");
}

TEST(PaintingUndo, TellsWhichLayerItWas) {
    core::ThreadPool pool(1);
    Painting painting(small_canvas(), pool);
    painting.apply(AddLayer{"Sky"});
    painting.apply(SetLayer{2, {.name = "Clouds", .opacity = 0.5}});
    painting.apply(GroupLayers{"Far", {2}});
    painting.apply(DryNow{});
    painting.apply(UngroupLayers{1});
    painting.apply(FlattenLayers{});
    const auto steps = painting.undo_steps();
    const std::vector<std::pair<std::string, std::string>> expected = {
        {"New layer", "Sky"},  {"Look of a layer", "Sky"}, {"Layers grouped", "Far"},
        {"Dry now", "Clouds"}, {"Group dissolved", "Far"}, {"Flattened", ""}};
    ASSERT_EQ(steps.size(), expected.size());
    for (std::size_t i = 0; i < steps.size(); ++i) {
        EXPECT_EQ(steps[i].step.name, expected[i].first) << i;
        EXPECT_EQ(steps[i].step.layer, expected[i].second) << i;
    }
}

/// A pen that comes down 30 mm to the left of the canvas and goes on to there.
void paint_from_beside(Painting& painting, double to_x_mm) {
    painting.apply(PenDown{.sample = {0.0, -30.0, 15.0, 0.5}, .beside = true});
    for (int i = 1; i <= 30; ++i)
        painting.apply(PenMove{{0.01 * i, -30.0 + (to_x_mm + 30.0) * i / 30.0, 15.0, 0.5}});
    painting.apply(PenUp{});
}

class UndoBeside : public testing::Test {
  protected:
    UndoBeside() {
        painting.apply(TakeBrush{"flat", 8, 1});
        painting.apply(load_of("PB29"));
        paint_wave(painting, 0.0, 10.0);
        painting.apply(DryNow{});
        painting.apply(Undo{});
        hash = painting.state_hash();
    }
    void expect_step_that_undo_takes_back() {
        EXPECT_EQ(painting.undo_steps().size(), 2U);
        EXPECT_FALSE(painting.can_redo());
        EXPECT_EQ(painting.late_strokes(), 1);
        EXPECT_NE(painting.state_hash(), hash);
        painting.apply(Undo{});
        EXPECT_EQ(painting.state_hash(), hash);
        EXPECT_LT(painting.account().volume_error_rel(), kRounding);
    }

    core::ThreadPool pool{1};
    Painting painting{small_canvas(), pool};
    std::uint64_t hash = 0;
};

TEST_F(UndoBeside, AStrokeThatTouchesNothingIsNoStep) {
    paint_from_beside(painting, -15.0);
    EXPECT_EQ(painting.undo_steps().size(), 1U);
    EXPECT_TRUE(painting.can_redo());
    EXPECT_EQ(painting.late_strokes(), 0);
    EXPECT_EQ(painting.state_hash(), hash);
    EXPECT_LT(painting.account().volume_error_rel(), kRounding);
}

TEST_F(UndoBeside, AStrokeThatComesInIsAStep) {
    paint_from_beside(painting, 20.0);
    expect_step_that_undo_takes_back();
}

TEST_F(UndoBeside, AMirrorMayTouchWhereTheHandDoesNot) {
    painting.apply(SetSymmetry{{.centre_x_mm = 0.0, .centre_y_mm = 15.0, .mirror = true}});
    paint_from_beside(painting, -15.0);
    expect_step_that_undo_takes_back();
}

TEST_F(UndoBeside, AStrokeThatIsTurnedWaitsOn) {
    painting.apply(PenDown{.sample = {0.0, -30.0, 15.0, 0.5}, .beside = true});
    painting.apply(TurnStroke{40.0});
    EXPECT_EQ(painting.undo_steps().size(), 1U);
    for (int i = 1; i <= 30; ++i)
        painting.apply(PenMove{{0.01 * i, -30.0 + 2.0 * i, 15.0, 0.5}});
    painting.apply(PenUp{});
    expect_step_that_undo_takes_back();
}

TEST_F(UndoBeside, AirThatReachesTheCanvasTouchesIt) {
    painting.apply(TakeBrush{"Air blower 40", 20, 1});
    paint_from_beside(painting, -2.0);
    EXPECT_EQ(painting.undo_steps().size(), 2U);
}

/// The well is 120 x 90 mm, the canvas another size.
TEST_F(UndoBeside, AirThatReachesTheWellTouchesIt) {
    painting.apply(SqueezePaint{{{{"PB29", 1.0}}, 1.0}, 200.0, 100.0, 45.0});
    painting.apply(Undo{});
    painting.apply(TakeBrush{"Air blower 40", 20, 1});
    const auto blow = [&](double x_mm) {
        painting.apply(
            PenDown{.sample = {0.0, 300.0, 45.0, 0.5}, .surface = Surface::Well, .beside = true});
        for (int i = 1; i <= 30; ++i)
            painting.apply(PenMove{{0.01 * i, 300.0 + (x_mm - 300.0) * i / 30.0, 45.0, 0.5}});
        painting.apply(PenUp{});
        return painting.late_strokes();
    };
    EXPECT_EQ(blow(200.0), 0);
    EXPECT_EQ(blow(100.0), 1);
}

/// From left to right, 25 mm below the canvas's upper edge.
void paint_low(Painting& painting, double from_x_mm, double to_x_mm) {
    painting.apply(PenDown{.sample = {0.0, from_x_mm, 25.0, 0.5}, .beside = true});
    for (int i = 1; i <= 30; ++i)
        painting.apply(PenMove{{0.01 * i, from_x_mm + (to_x_mm - from_x_mm) * i / 30.0, 25.0, 0.5}});
    painting.apply(PenUp{});
}

TEST_F(UndoBeside, AStrokeBesideTheSelectionIsNoStep) {
    painting.apply(SelectArea{{{0, 20}, {10, 20}, {10, 30}, {0, 30}}});
    const std::size_t steps = painting.undo_steps().size();
    paint_low(painting, 25.0, 35.0);
    EXPECT_EQ(painting.undo_steps().size(), steps);
    EXPECT_EQ(painting.late_strokes(), 0);
    paint_low(painting, 25.0, 5.0);
    EXPECT_EQ(painting.undo_steps().size(), steps + 1);
    EXPECT_EQ(painting.late_strokes(), 1);
    EXPECT_LT(painting.account().volume_error_rel(), kRounding);
}

TEST_F(UndoBeside, AStrokeOnMaskingFluidIsNoStep) {
    painting.apply(MaskStripe{{{0, 25}, {40, 25}}, 30});
    const std::size_t steps = painting.undo_steps().size();
    paint_low(painting, 10.0, 30.0);
    EXPECT_EQ(painting.undo_steps().size(), steps);
}

TEST_F(UndoBeside, ADryBrushOnBareCanvasIsNoStep) {
    painting.apply(Undo{});
    painting.apply(TakeBrush{"flat", 8, 2});
    const std::size_t undone = painting.redo_steps().size();
    paint_low(painting, 10.0, 30.0);
    EXPECT_TRUE(painting.undo_steps().empty());
    EXPECT_EQ(painting.redo_steps().size(), undone) << "nothing was painted over what was undone";
    painting.apply(load_of("PB29"));
    paint_low(painting, 10.0, 30.0);
    EXPECT_EQ(painting.undo_steps().size(), 1U);
    EXPECT_FALSE(painting.can_redo());
}

TEST_F(UndoBeside, UndoDuringItTakesBackWhatWasBefore) {
    painting.apply(PenDown{.sample = {0.0, -30.0, 15.0, 0.5}, .beside = true});
    painting.apply(Undo{});
    EXPECT_EQ(painting.undo_steps().size(), 0U);
    EXPECT_EQ(painting.redo_steps().size(), 2U);
}

class UndoAtRest : public testing::Test {
  protected:
    UndoAtRest() {
        painting.apply(TakeBrush{"flat", 8, 1});
        painting.apply(load_of("PB29"));
        paint_wave(painting, 0.0, 8.0);
        rest();
        paint_wave(painting, 1.0, 22.0);
        advance(painting, 2);
    }
    void rest() {
        constexpr int kMostTicks = 6000;
        painting.advance_tick();
        for (int tick = 0; tick < kMostTicks && painting.film_report().awake_tiles > 0; ++tick)
            painting.advance_tick();
    }
    std::int64_t cells_of_next_tick() {
        const std::int64_t before = painting.film_report().cells_stepped;
        painting.advance_tick();
        return painting.film_report().cells_stepped - before;
    }

    core::ThreadPool pool{1};
    Painting painting{small_canvas(), pool};
};

TEST_F(UndoAtRest, PaintThatSleptSleepsOn) {
    EXPECT_GT(painting.film_report().awake_tiles, 0);
    painting.apply(Undo{});
    const std::uint64_t hash = painting.state_hash();
    EXPECT_EQ(cells_of_next_tick(), 0);
    EXPECT_EQ(painting.film_report().awake_tiles, 0);
    EXPECT_EQ(painting.state_hash(), hash);
}

TEST_F(UndoAtRest, PaintThatMovedMovesOn) {
    painting.apply(Undo{});
    painting.apply(Redo{});
    EXPECT_GT(cells_of_next_tick(), 0);
}

TEST_F(UndoAtRest, PaintOnACanvasThatWasTiltedSinceIsAwake) {
    painting.apply(TiltCanvas{60, 90});
    painting.apply(Undo{});
    EXPECT_GT(cells_of_next_tick(), 0);
}

}  // namespace
}  // namespace pastoso::document
