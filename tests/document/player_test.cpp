#include "document/player.hpp"

#include "document/error_of.hpp"
#include "document/recorder.hpp"
#include "document/scenes.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace pastoso::document {
namespace {

using testing::HasSubstr;

std::uint64_t replay_hash(const Recording& recording, int threads) {
    core::ThreadPool pool(threads);
    Painting painting(recording.canvas, pool);
    Player player(painting, recording);
    while (!player.finished())
        player.play_tick();
    EXPECT_EQ(painting.tick(), recording.end_tick);
    EXPECT_LT(painting.account().volume_error_rel(), 1e-9);
    return painting.state_hash();
}

TEST(Player, TheSameRecordingGivesTheSameBits) {
    const Recording recording = crossing_session();
    EXPECT_EQ(replay_hash(recording, 1), replay_hash(recording, 1));
}

TEST(Player, AReplayEqualsTheLiveSessionItWasLoggedIn) {
    core::ThreadPool pool(2);
    Painting painting(small_canvas(), pool);
    Recorder recorder(painting.settings());
    const auto act = [&](const Action& action) {
        painting.apply(action);
        recorder.add(painting.tick(), action);
    };
    act(UseMedium{"soft-body acrylic"});
    act(TakeBrush{"flat", 9, 3});
    act(load_of("PR254"));
    act(PenDown{wave_sample(0.0, 9.0, 0)});
    for (int i = 1; i <= 30; ++i) {
        act(PenMove{wave_sample(0.0, 9.0, i)});
        // An uneven pace, as of a busy machine.
        if (i % 7 == 3) painting.advance_tick();
        if (i % 11 == 5) act(TiltCanvas{30.0 + i, 90.0});
    }
    painting.advance_tick();
    act(PenUp{});
    painting.advance_tick();
    act(load_of("PW6"));
    act(PenDown{wave_sample(1.0, 11.0, 0)});
    for (int i = 1; i <= 20; ++i)
        act(PenMove{wave_sample(1.0, 11.0, i)});
    painting.advance_tick();
    act(Undo{});
    act(PenMove{wave_sample(1.0, 11.0, 21)});
    painting.advance_tick();
    act(Redo{});
    for (int i = 0; i < 10; ++i)
        painting.advance_tick();

    recorder.note_tick(painting.tick());
    EXPECT_EQ(replay_hash(recorder.recording(), 1), painting.state_hash());
}

TEST(Player, ErrorsNameTheEvent) {
    Recording recording = crossing_session();
    recording.events[2] = {0, UseMedium{"honey"}};
    core::ThreadPool pool(1);
    Painting painting(recording.canvas, pool);
    Player player(painting, recording);
    EXPECT_THAT(error_of([&] { player.play_tick(); }), HasSubstr("event 2: "));
}

TEST(Player, AnEmptyRecordingIsFinishedAtItsEnd) {
    Recording recording;
    recording.canvas = small_canvas();
    recording.end_tick = 2;
    core::ThreadPool pool(1);
    Painting painting(recording.canvas, pool);
    Player player(painting, recording);
    EXPECT_EQ(player.progress(), 0.0);
    player.play_tick();
    EXPECT_EQ(player.progress(), 0.5);
    EXPECT_FALSE(player.finished());
    player.play_tick();
    EXPECT_EQ(player.progress(), 1.0);
    EXPECT_TRUE(player.finished());
}

TEST(Player, EventsOfTheLastTickAreApplied) {
    Recording recording;
    recording.canvas = small_canvas();
    recording.events = {{0, TakeBrush{"flat", 8, 1}}, {1, load_of("PB29")}};
    recording.end_tick = 1;
    core::ThreadPool pool(1);
    Painting painting(recording.canvas, pool);
    Player player(painting, recording);
    while (!player.finished())
        player.play_tick();
    EXPECT_EQ(painting.tick(), 1);
    EXPECT_GT(painting.account().brush.volume_mm3, 0.0);
}

TEST(PlayerThreads, AnyNumberOfThreadsGivesTheSameBits) {
    const Recording recording = crossing_session();
    const std::uint64_t hash = replay_hash(recording, 1);
    EXPECT_EQ(replay_hash(recording, 2), hash);
    EXPECT_EQ(replay_hash(recording, 3), hash);
}

}  // namespace
}  // namespace pastoso::document
