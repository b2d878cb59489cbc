#include "document/recorder.hpp"

#include "core/random.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>
#include <limits>
#include <vector>

#include <gtest/gtest.h>

namespace pastoso::document {
namespace {

/// Bits, not values: -0.0 is not 0.0.
bool same_bits(const TimedSample& a, const TimedSample& b) {
    return a.tick == b.tick && std::memcmp(&a.sample, &b.sample, sizeof(brush::PenSample)) == 0;
}

void expect_kept(const std::vector<TimedSample>& wanted) {
    PackedMoves moves;
    for (const TimedSample& move : wanted)
        moves.add(move);
    ASSERT_EQ(moves.size(), wanted.size());
    PackedMoves::Reader reader(moves);
    for (std::size_t i = 0; i < wanted.size(); ++i)
        ASSERT_TRUE(same_bits(reader.next(), wanted[i])) << "move " << i;
}

/// A hand that draws loops, as a tablet of 200 reports a second tells it.
TimedSample drawn(int i) {
    const double time_s = 100.0 + 0.005 * i;
    return {static_cast<std::int64_t>(time_s * 60.0),
            {.time_s = time_s,
             .x_mm = 150.0 + 90.0 * std::cos(2.3 * time_s),
             .y_mm = 100.0 + 70.0 * std::sin(3.3 * time_s),
             .pressure = std::round(8191.0 * (0.5 + 0.3 * std::sin(time_s))) / 8191.0}};
}

/// Any bits, which are any values.
TimedSample scrambled(std::uint32_t i) {
    const auto value = [&](std::uint32_t stream) {
        const std::uint64_t high = core::scramble(16 * i + stream);
        const std::uint64_t low = core::scramble(16 * i + stream + 8);
        return std::bit_cast<double>(high << 32 | low);
    };
    return {static_cast<std::int64_t>(i) * i,
            {value(0), value(1), value(2), value(3), value(4), value(5), value(6), value(7)}};
}

TEST(PackedMoves, ComeBackBitByBit) {
    std::vector<TimedSample> hand, any;
    for (int i = 0; i < 20000; ++i)
        hand.push_back(drawn(i));
    for (std::uint32_t i = 0; i < 20000; ++i)
        any.push_back(scrambled(i));
    expect_kept(hand);
    expect_kept(any);
}

TEST(PackedMoves, TheFurthestJumpsComeBackToo) {
    using Limits = std::numeric_limits<double>;
    std::vector<TimedSample> moves;
    for (const double value : {0.0, -0.0, Limits::max(), -Limits::max(), Limits::denorm_min(), 1.0,
                               Limits::infinity(), -Limits::quiet_NaN()}) {
        moves.push_back({std::numeric_limits<std::int64_t>::max(), {.x_mm = value}});
        moves.push_back({0, {.x_mm = -value, .tilt_x_deg = value}});
    }
    expect_kept(moves);
}

/// An hour of it is below 20 MB.
TEST(PackedMoves, AHandTakesATenthOfItsEvents) {
    constexpr int kMoves = 100000;
    PackedMoves moves;
    for (int i = 0; i < kMoves; ++i)
        moves.add(drawn(i));
    EXPECT_LT(moves.bytes(), kMoves * sizeof(Event) / 10);
}

/// Moves, and between them whatever else happens.
Recording mixed_session() {
    Recording recording{{}, {{0, UseMedium{"heavy-body oil"}}, {2, TakeBrush{"flat"}}}, 900};
    for (int i = 0; i < 3000; ++i) {
        const TimedSample move = drawn(i);
        const std::int64_t tick = move.tick - 6000 + 2;
        if (i % 100 == 0) recording.events.push_back({tick, PenDown{move.sample}});
        recording.events.push_back({tick, PenMove{move.sample}});
        if (i % 100 == 99) recording.events.push_back({tick, PenUp{}});
        if (i % 300 == 299) recording.events.push_back({tick, Undo{}});
    }
    recording.end_tick += recording.events.back().tick;
    return recording;
}

TEST(Recorder, TellsTheSessionInItsOrder) {
    const Recording wanted = mixed_session();
    Recorder recorder(wanted.canvas);
    for (const Event& event : wanted.events)
        recorder.add(event.tick, event.action);
    EXPECT_EQ(recorder.recording().end_tick, wanted.events.back().tick);
    recorder.note_tick(wanted.end_tick);
    EXPECT_EQ(recorder.recording(), wanted);
}

TEST(Recorder, GoesOnWithAPast) {
    const Recording past = mixed_session();
    Recorder recorder(past);
    EXPECT_EQ(recorder.recording(), past);
    Recording wanted = past;
    wanted.end_tick += 5;
    wanted.events.push_back({wanted.end_tick, PenMove{drawn(7).sample}});
    recorder.add(wanted.end_tick, PenMove{drawn(7).sample});
    EXPECT_EQ(recorder.recording(), wanted);
}

/// Copied at every size around those of its blocks.
TEST(Recorder, ACopyStaysAsItWasWhileTheSessionGoesOn) {
    const Recording whole = mixed_session();
    Recorder recorder(whole.canvas);
    std::vector<Recorder> copies;
    for (const Event& event : whole.events) {
        copies.push_back(recorder);
        recorder.add(event.tick, event.action);
    }
    for (std::size_t count = 0; count < copies.size(); count += 71) {
        const Recording then = copies[count].recording();
        ASSERT_EQ(then.events.size(), count);
        EXPECT_TRUE(std::equal(then.events.begin(), then.events.end(), whole.events.begin()));
    }
    copies[100].add(whole.end_tick, PenUp{});
    EXPECT_EQ(recorder.recording().events, whole.events);
}

TEST(Recorder, TellsWhatItHoldsWithoutUnpacking) {
    const Recording session = mixed_session();
    const Recorder recorder(session);
    EXPECT_EQ(recorder.strokes(), 30);
    EXPECT_EQ(recorder.end_tick(), session.end_tick);
    EXPECT_TRUE(recorder.changes_painting());
    Recorder untouched(session.canvas);
    untouched.add(3, TakeBrush{"flat"});
    EXPECT_FALSE(untouched.changes_painting());
    EXPECT_EQ(untouched.strokes(), 0);
}

TEST(RecorderDeathTest, TimeDoesNotRunBack) {
    Recorder recorder(CanvasSettings{});
    recorder.add(5, PenUp{});
    EXPECT_DEATH(recorder.add(4, PenUp{}), "tick");
}

}  // namespace
}  // namespace pastoso::document
