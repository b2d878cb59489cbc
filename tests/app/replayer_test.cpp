// A recording that is watched: the same paint at every moment, however one comes there.
#include "session/replayer.hpp"

#include "app/recorded_strokes.hpp"

#include <algorithm>
#include <condition_variable>
#include <mutex>
#include <thread>

#include <gmock/gmock.h>

namespace pastoso::session {
namespace {

using namespace document;
using ::testing::HasSubstr;

/// 33 s of them.
Recording four_strokes() {
    Recording recording = tests::runny_recording(2.0, 2000);
    tests::add_stroke(recording, 10, 5.0);
    tests::add_stroke(recording, 500, 10.0);
    tests::add_stroke(recording, 1000, 15.0);
    tests::add_stroke(recording, 1500, 20.0);
    recording.events.push_back({2000, DryNow{}});  // after the last tick
    return recording;
}

std::uint64_t hash_at(const Recording& recording, std::int64_t tick) {
    core::ThreadPool pool(1);
    Painting painting(recording.canvas, pool);
    painting.keep_undo_steps(undo_depth(recording));
    Player player(painting, recording);
    while (tick == recording.end_tick ? !player.finished() : painting.tick() < tick)
        player.play_tick();
    return film::state_hash(painting.film());
}

class ReplayerTest : public ::testing::Test {
  protected:
    void watch(const Recording& recording) {
        replayer_ = std::make_unique<Replayer>(recording, [this] {
            const std::lock_guard lock(mutex_);
            told_.notify_all();
        });
    }
    template <class Condition>
    void wait_for(const Condition& condition) {
        std::unique_lock lock(mutex_);
        while (!condition(replayer_->status()))
            told_.wait_for(lock, std::chrono::milliseconds(20));
    }
    void wait_until_found() {
        wait_for([](const Replayer::Status& status) { return !status.seeking; });
    }
    std::uint64_t shown() const { return film::state_hash(replayer_->snapshot()->film); }

    std::mutex mutex_;
    std::condition_variable told_;
    std::unique_ptr<Replayer> replayer_;
};

TEST_F(ReplayerTest, EndsWithTheSamePainting) {
    const Recording recording = four_strokes();
    watch(recording);
    replayer_->set_speed(kFullSpeed);
    wait_for([](const auto& status) { return status.tick == 2000 && !status.playing; });
    EXPECT_EQ(shown(), hash_at(recording, 2000));
}

TEST_F(ReplayerTest, EveryMomentIsTheSameHoweverOneComesThere) {
    const Recording recording = four_strokes();
    watch(recording);
    replayer_->set_playing(false);
    for (const std::int64_t tick : {700, 1900, 1100, 300, 1600, 0, 2000, 515, 1510}) {
        replayer_->seek(tick);
        wait_until_found();
        EXPECT_EQ(replayer_->status().tick, tick);
        EXPECT_EQ(shown(), hash_at(recording, tick)) << tick;
        EXPECT_FALSE(replayer_->status().playing);
    }
}

TEST_F(ReplayerTest, WhatIsSaidIsSaidOfWhatIsSeen) {
    watch(four_strokes());
    replayer_->set_playing(false);
    for (int round = 0; round < 200; ++round) {
        const std::int64_t tick = 20 + round % 2;
        replayer_->seek(tick);
        while (replayer_->status().seeking)
            std::this_thread::yield();
        ASSERT_EQ(replayer_->status().tick, tick) << round;
        ASSERT_EQ(replayer_->snapshot()->tick, tick) << round;
    }
}

TEST_F(ReplayerTest, GoesBackBehindAnUndo) {
    Recording recording = four_strokes();
    recording.events.insert(recording.events.end() - 1,
                            {{1600, Undo{}}, {1600, Undo{}}, {1700, Redo{}}});
    watch(recording);
    replayer_->set_playing(false);
    for (const std::int64_t tick : {2000, 1550, 1650, 1200, 2000}) {
        replayer_->seek(tick);
        wait_until_found();
        EXPECT_EQ(shown(), hash_at(recording, tick)) << tick;
    }
}

TEST_F(ReplayerTest, StandsStillUntilItIsPlayedAndBeginsAnewAtTheEnd) {
    watch(four_strokes());
    replayer_->set_playing(false);
    replayer_->seek(2000);
    wait_until_found();
    EXPECT_EQ(replayer_->status().tick, 2000);
    // So slowly that its beginning cannot be missed: it takes half an hour to the middle.
    replayer_->set_speed(0.01);
    replayer_->set_playing(true);
    wait_for([](const auto& status) { return status.tick < 1000; });
    EXPECT_TRUE(replayer_->status().playing);
    replayer_->set_speed(kFullSpeed);
    wait_for([](const auto& status) { return status.tick == 2000 && !status.playing; });
}

TEST_F(ReplayerTest, TellsWhyItCannotGoOn) {
    Recording recording = four_strokes();
    recording.events.insert(recording.events.end() - 1, {1900, TakeBrush{"No such brush", 8.0, 1}});
    watch(recording);
    replayer_->set_speed(kFullSpeed);
    wait_for([](const auto& status) { return !status.error.empty(); });
    EXPECT_THAT(replayer_->status().error.text(), HasSubstr("No such brush"));
    EXPECT_FALSE(replayer_->status().playing);
}

TEST_F(ReplayerTest, EndsInTheMiddle) {
    watch(four_strokes());
    replayer_.reset();
    SUCCEED();
}

}  // namespace
}  // namespace pastoso::session
