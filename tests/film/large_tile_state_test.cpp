// The orders in which the state of a tile may change in a large step.
#include "film/large/large_tile_state.hpp"

#include <limits>

#include <gtest/gtest.h>

namespace pastoso::film {
namespace {

constexpr float kTolerance = 0.01F;

LargeTileState at_start() {
    LargeTileState state;
    state.begin_step();
    return state;
}

/// After the decision of a sweep in which this error was found.
LargeTileState after_error(LargeTileState state, float error) {
    state.enter_sweep(true);
    state.note_error(error);
    state.choose_correction(false, kTolerance);
    return state;
}

TEST(LargeTileState, BeginsWithNewChangesAndUnsteadyDrag) {
    const LargeTileState state = at_start();
    EXPECT_TRUE(state.change_is_new());
    EXPECT_TRUE(state.equations_changed());
    EXPECT_TRUE(state.is_unsteady());
    EXPECT_FALSE(state.is_corrected());
    EXPECT_FALSE(state.is_slow());
}

TEST(LargeTileState, IsCorrectedWhereItsErrorIsTooLargeOrNoNumber) {
    EXPECT_TRUE(after_error(at_start(), 0.1F).is_corrected());
    EXPECT_TRUE(after_error(at_start(), std::numeric_limits<float>::quiet_NaN()).is_corrected());
    EXPECT_FALSE(after_error(at_start(), kTolerance).is_corrected());
}

TEST(LargeTileState, FlowIsStaleOnceWhatMakesItHasChanged) {
    const auto with_known_flow = [] {
        LargeTileState state = after_error(at_start(), 0.0F);
        state.blend(false, false);
        state.note_flow();
        return state;
    };
    EXPECT_TRUE(at_start().flow_is_stale());
    EXPECT_FALSE(with_known_flow().flow_is_stale());
    LargeTileState changed = with_known_flow(), moved = with_known_flow(), beside = with_known_flow();
    changed.change_equations();
    moved.blend(true, false);
    beside.join_moved();
    for (const LargeTileState& state : {changed, moved, beside})
        EXPECT_TRUE(state.flow_is_stale());
    LargeTileState same = with_known_flow();
    same.enter_sweep(false);
    same.blend(false, true);
    EXPECT_FALSE(same.flow_is_stale());
}

TEST(LargeTileState, ErrorsOfATileThatDoesNotCountStayAsTheyWere) {
    LargeTileState state = after_error(at_start(), 0.1F);
    state.blend(false, false);
    state.enter_sweep(false);
    state.note_error(0.5F);
    EXPECT_EQ(state.error(), 0.1F);
    EXPECT_FALSE(state.choose_correction(true, kTolerance));
}

TEST(LargeTileState, IsSlowOnceACorrectionHardlyLoweredItsError) {
    LargeTileState state = after_error(at_start(), 0.4F);
    EXPECT_FALSE(state.is_slow());
    state.blend(false, true);
    EXPECT_FALSE(after_error(state, 0.1F).is_slow());
    EXPECT_TRUE(after_error(state, 0.11F).is_slow());
    state.change_equations();
    EXPECT_FALSE(after_error(state, 0.4F).is_slow());
}

TEST(LargeTileState, ChangesAreStaleAfterAMovedPressureUntilTheyAnswerIt) {
    LargeTileState state = after_error(at_start(), 0.1F);
    state.blend(true, false);
    EXPECT_TRUE(state.pressure_moved() && state.change_is_stale());
    EXPECT_FALSE(state.equations_changed());
    state.answer_pressure();
    EXPECT_TRUE(state.change_is_new());
    EXPECT_FALSE(state.change_is_stale());

    LargeTileState beside = after_error(at_start(), 0.0F);
    beside.blend(false, false);
    EXPECT_FALSE(beside.change_is_new() || beside.change_is_stale());
    beside.join_moved();
    EXPECT_TRUE(beside.change_is_stale());
    EXPECT_FALSE(beside.pressure_moved());
}

TEST(LargeTileState, DragIsSteadyUntilAFluxWasWrong) {
    LargeTileState state = at_start();
    state.steady_drag();
    EXPECT_FALSE(state.is_unsteady());
    state.unsettle_drag();
    EXPECT_TRUE(state.is_unsteady());
}

TEST(LargeTileStateDeathTest, OrdersThatNoStepTakesAreBrokenInvariants) {
    EXPECT_DEATH(at_start().answer_pressure(), "broken invariant");
    EXPECT_DEATH(at_start().join_moved(), "broken invariant");
    EXPECT_DEATH(LargeTileState().steady_drag(), "broken invariant");
    LargeTileState counts = at_start();
    counts.enter_sweep(true);
    EXPECT_DEATH(counts.enter_sweep(true), "broken invariant");
    EXPECT_DEATH(counts.blend(false, false), "broken invariant");
    EXPECT_DEATH(counts.change_equations(), "broken invariant");
    LargeTileState moved = after_error(at_start(), 0.1F);
    moved.blend(true, false);
    EXPECT_DEATH(moved.enter_sweep(false), "broken invariant");
    EXPECT_DEATH(moved.blend(true, false), "broken invariant");
}

}  // namespace
}  // namespace pastoso::film
