// A painting that is made again of its state goes on as if nothing had happened.
#include "document/painting_state.hpp"

#include "core/error.hpp"
#include "document/hasty_painter.hpp"
#include "document/painting.hpp"
#include "document/player.hpp"
#include "document/well_session.hpp"
#include "film/state.hpp"

#include <gtest/gtest.h>

namespace pastoso::document {
namespace {

/// Some runny paint that dries, with a rag, a fan and an undo.
Recording drying_session() {
    Recording recording = crossing_session();
    recording.events.insert(
        recording.events.begin(),
        {0,
         SetDrying{{.speed = 4000.0, .fan = 3.0, .fan_x_mm = 20, .fan_y_mm = 10, .fan_radius_mm = 15}}});
    auto& events = recording.events;
    events.push_back({50, Undo{}});
    events.push_back({52, TakeBrush{"rag", 12, 3}});
    events.push_back({52, SetStabiliser{{.smoothing_ms = 40.0, .string_mm = 1.0}}});
    events.push_back({52, SetSymmetry{{.centre_x_mm = 20, .centre_y_mm = 15, .mirror = true}}});
    for (int i = 0; i <= 20; ++i) {
        const brush::PenSample sample = wave_sample(1.0, 14.0, i);
        if (i == 0)
            events.push_back({60, PenDown{sample}});
        else
            events.push_back({60 + i, PenMove{sample}});
    }
    events.push_back({90, PenUp{}});
    recording.end_tick = 130;
    return recording;
}

/// Plays the recording, and at `tick` goes on with a painting made of the state, if no stroke is in
/// progress there. Returns the final hash.
std::uint64_t hash_with_change_at(const Recording& recording, std::int64_t tick, bool& changed) {
    core::ThreadPool pool(2);
    Painting first(recording.canvas, pool);
    Player player(first, recording);
    while (!player.finished() && first.tick() < tick)
        player.play_tick();
    changed = !first.stroke_in_progress();
    if (!changed) return 0;
    Painting second(first.state(), pool);
    EXPECT_EQ(second.state_hash(), first.state_hash());
    EXPECT_EQ(second.tick(), first.tick());
    EXPECT_FALSE(second.can_undo());
    Recording rest = recording;
    std::erase_if(rest.events, [&](const Event& event) { return event.tick < tick; });
    Player player_of_rest(second, rest);
    while (!player_of_rest.finished())
        player_of_rest.play_tick();
    const Account account = second.account();
    EXPECT_LT(account.volume_error_rel(), 1e-9);
    EXPECT_LT(account.pigment_error_rel(), 1e-9);
    return second.state_hash();
}

void expect_same_at_any_tick(const Recording& recording, int step) {
    core::ThreadPool pool(1);
    Painting whole(recording.canvas, pool);
    Player player(whole, recording);
    while (!player.finished())
        player.play_tick();
    int changes = 0;
    for (std::int64_t tick = 1; tick < recording.end_tick; tick += step) {
        bool changed = false;
        const std::uint64_t hash = hash_with_change_at(recording, tick, changed);
        if (!changed) continue;
        ++changes;
        EXPECT_EQ(hash, whole.state_hash()) << "changed at tick " << tick;
    }
    EXPECT_GE(changes, 3);
}

TEST(PaintingState, RunningPaintGoesOnToTheSameBits) {
    expect_same_at_any_tick(crossing_session(), 7);
}

TEST(PaintingState, TheMixingWellGoesOnToTheSameBits) {
    expect_same_at_any_tick(mixing_session(), 5);
}

TEST(PaintingState, DryingPaintAndARagGoOnToTheSameBits) {
    // What is undone after the change is not there to return to, so the change comes after it.
    Recording recording = drying_session();
    core::ThreadPool pool(2);
    Painting whole(recording.canvas, pool);
    Player player(whole, recording);
    while (!player.finished())
        player.play_tick();
    for (const std::int64_t tick : {51, 57, 95, 110, 125}) {
        bool changed = false;
        EXPECT_EQ(hash_with_change_at(recording, tick, changed), whole.state_hash()) << tick;
        EXPECT_TRUE(changed) << tick;
    }
}

film::Consistencies well_of(const PaintingState& state) {
    return state.value.well ? state.value.well->consistencies : film::Consistencies{};
}

// To take a painting up again is to change nothing: whatever came before, layers, several media and a
// well among it.
TEST(PaintingState, MakesTheSamePaintingAgainAfterAnyAction) {
    core::ThreadPool pool(2);
    for (std::uint32_t seed = 1; seed <= 3; ++seed) {
        Painting painting(hasty_canvas(), pool);
        HastyPainter painter(seed);
        for (int turn = 0; turn < 60; ++turn) {
            for (const Action& action : painter.next()) {
                try {
                    painting.apply(action);
                } catch (const core::InputError&) {
                    continue;  // there is no such layer, or nothing that could be done
                }
                if (std::holds_alternative<PenUp>(action)) painting.advance_tick();
            }
            const PaintingState state = painting.state();
            const PaintingState again = Painting(state, pool).state();
            ASSERT_EQ(state_hash(again), state_hash(state)) << "turn " << turn << " of seed " << seed;
            ASSERT_EQ(again.value.film.consistencies, state.value.film.consistencies);
            ASSERT_EQ(well_of(again), well_of(state));
        }
    }
}

TEST(PaintingState, TellsWhatIsInHand) {
    core::ThreadPool pool(1);
    Painting painting(small_canvas(), pool);
    EXPECT_FALSE(painting.state().value.brush);
    painting.apply(UseMedium{"house paint"});
    painting.apply(TiltCanvas{30, 45});
    painting.apply(TakeBrush{"round", 9, 5});
    painting.apply(load_of("PR108", 0.5));
    const PaintingState state = painting.state();
    EXPECT_EQ(state.value.medium, UseMedium{"house paint"});
    EXPECT_EQ(state.value.tilt, (TiltCanvas{30, 45}));
    ASSERT_TRUE(state.value.brush);
    EXPECT_EQ(state.value.brush->taken, (TakeBrush{"round", 9, 5}));
    EXPECT_FALSE(state.value.well);
    EXPECT_EQ(state_hash(state), painting.state_hash());
    for (int tile = 0; tile < state.value.bare->support_mm.tile_count(); ++tile)
        EXPECT_TRUE(state.value.bare->support_mm.shares_tile(state.value.film.support_mm, tile));
}

}  // namespace
}  // namespace pastoso::document
