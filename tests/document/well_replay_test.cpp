// Recordings that mix on the well, replayed.
#include "document/player.hpp"
#include "document/well_session.hpp"

#include <gtest/gtest.h>

namespace pastoso::document {
namespace {

struct Replayed {
    std::uint64_t hash = 0;
    Account account;
};

Replayed replay(const Recording& recording, int threads) {
    core::ThreadPool pool(threads);
    Painting painting(recording.canvas, pool);
    Player player(painting, recording);
    while (!player.finished())
        player.play_tick();
    EXPECT_NE(painting.well(), nullptr);
    return {painting.state_hash(), painting.account()};
}

TEST(WellThreads, AnyNumberOfThreadsGivesTheSameBits) {
    const Recording recording = mixing_session();
    const std::uint64_t hash = replay(recording, 1).hash;
    EXPECT_EQ(replay(recording, 1).hash, hash);
    EXPECT_EQ(replay(recording, 2).hash, hash);
    EXPECT_EQ(replay(recording, 3).hash, hash);
}

TEST(WellReplay, AFinerCanvasGetsTheSamePaintFromTheSameWell) {
    Recording recording = mixing_session();
    const Account coarse = replay(recording, 2).account;
    recording.canvas.px_per_mm = 6.0;
    const Account fine = replay(recording, 2).account;
    // The well is mixed alike until the brush has been on the canvas; what a stroke leaves there differs
    // by a few per cent between 3 and 6 cells a millimetre.
    EXPECT_NEAR(fine.taken.volume_mm3, coarse.taken.volume_mm3, 1e-9);
    EXPECT_NEAR(fine.well.volume_mm3, coarse.well.volume_mm3, 0.01 * coarse.well.volume_mm3);
    EXPECT_NEAR(fine.canvas.volume_mm3, coarse.canvas.volume_mm3, 0.06 * coarse.canvas.volume_mm3);
    EXPECT_NEAR(fine.canvas.pigment[5], coarse.canvas.pigment[5], 0.1 * coarse.canvas.pigment[5]);
    EXPECT_LT(fine.volume_error_rel(), 1e-12);
    EXPECT_LT(fine.pigment_error_rel(), 1e-12);
}

TEST(WellReplay, WhereItGaveUpATickIsNotSeen) {
    const Recording recording = mixing_session();
    core::ThreadPool pool(2);
    Painting painting(recording.canvas, pool);
    std::size_t next = 0;
    int tries = 0;
    while (painting.tick() < recording.end_tick) {
        for (; next < recording.events.size() && recording.events[next].tick <= painting.tick(); ++next)
            painting.apply(recording.events[next].action);
        int asked = 0;
        // Every other try ends in the middle of the tick.
        while (!painting.advance_tick_unless([&] { return tries % 2 == 0 && ++asked > 1; }))
            ++tries;
        ++tries;
    }
    EXPECT_EQ(painting.state_hash(), replay(recording, 2).hash);
}

}  // namespace
}  // namespace pastoso::document
