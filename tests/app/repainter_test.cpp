// A painting that is painted again, and one that is given up.
#include "session/repainter.hpp"

#include "app/recorded_strokes.hpp"
#include "document/painting_state.hpp"
#include "document/player.hpp"

#include <atomic>
#include <chrono>
#include <thread>

#include <gtest/gtest.h>

namespace pastoso::session {
namespace {

using namespace document;

/// A second of it.
Recording one_stroke(double px_per_mm) {
    Recording recording = tests::runny_recording(px_per_mm, 60);
    tests::add_stroke(recording, 1, 10.0);
    return recording;
}

template <class Condition>
void wait_for(const Condition& condition) {
    while (!condition())
        std::this_thread::sleep_for(std::chrono::milliseconds(1));
}

TEST(Repainter, PaintsWhatThePlayerPaints) {
    const Recording strokes = one_stroke(4.0);
    std::atomic<int> told = 0;
    Repainter repainter(strokes, "strokes", [&] { ++told; });
    wait_for([&] { return repainter.painted() != nullptr; });
    wait_for([&] { return told >= 2; });  // its first picture and its end
    EXPECT_EQ(repainter.status().done, 1.0);

    core::ThreadPool pool(1);
    Painting painting(strokes.canvas, pool);
    Player player(painting, strokes);
    while (!player.finished())
        player.play_tick();
    EXPECT_EQ(state_hash(repainter.painted()->painting), painting.state_hash());
}

/// A long first tick, at whose end there is something to tell: that it cannot go on.
Recording long_tick_that_fails() {
    Recording strokes = one_stroke(4.0);
    strokes.events.assign(5000, {0, TakeBrush{"Flat bristle 20", 8.0, 1}});
    strokes.events.push_back({0, UseMedium{"no such medium"}});
    return strokes;
}

TEST(Repainter, TellsNothingOnceItIsGivenUp) {
    std::atomic<bool> is_given_up = false;
    std::atomic<int> told_late = 0;
    for (int round = 0; round < 4; ++round) {
        is_given_up = false;
        Repainter repainter(long_tick_that_fails(), "strokes", [&] { told_late += is_given_up; });
        std::this_thread::sleep_for(std::chrono::milliseconds(10 * round));
        repainter.cancel();
        is_given_up = true;
    }
    EXPECT_EQ(told_late, 0);
}

TEST(Repainter, WhatIsPausedGoesOnOrIsGivenUp) {
    Repainter repainter(one_stroke(4.0), "strokes", [] {});
    repainter.set_paused(true);
    EXPECT_TRUE(repainter.status().paused);
    repainter.set_paused(false);
    wait_for([&] { return repainter.painted() != nullptr; });
    Repainter other(one_stroke(4.0), "strokes", [] {});
    other.set_paused(true);
    // It ends although nothing goes on.
}

TEST(Repainter, SaysWhyItCannotGoOn) {
    Recording strokes = one_stroke(4.0);
    strokes.events[0].action = UseMedium{"no such medium"};
    Repainter repainter(strokes, "The painting", [] {});
    wait_for([&] { return !repainter.status().error.empty(); });
    EXPECT_EQ(repainter.status().error.text().find("The painting, event 0"), 0)
        << repainter.status().error.text();
    EXPECT_EQ(repainter.painted(), nullptr);
}

}  // namespace
}  // namespace pastoso::session
