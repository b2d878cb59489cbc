#include "session/live_speed.hpp"

#include <algorithm>

#include <gtest/gtest.h>

namespace pastoso::session {
namespace {

TEST(LiveSpeed, TheFinestIsTakenThatLeavesTimeForThePicture) {
    const auto px_for = [](double load_at_8) {
        return live_px_per_mm([=](double px) { return load_at_8 * px * px / 64.0; });
    };
    EXPECT_EQ(px_for(0.1), 8.0);
    EXPECT_EQ(px_for(0.19), 8.0);
    EXPECT_EQ(px_for(0.21), 6.0);
    EXPECT_EQ(px_for(0.35), 6.0);
    EXPECT_EQ(px_for(0.36), 4.0);
    EXPECT_EQ(px_for(100.0), 4.0) << "something has to be painted on";
}

TEST(LiveSpeed, FinerCellsAreMoreWork) {
    core::ThreadPool pool;
    // The least of several, since other programs can only make it more.
    const auto least = [&](double px_per_mm) {
        return std::min({painting_load(px_per_mm, pool), painting_load(px_per_mm, pool),
                         painting_load(px_per_mm, pool)});
    };
    const double coarse = least(2.0);
    EXPECT_GT(coarse, 0.0);
    EXPECT_GT(least(8.0), coarse);
}

}  // namespace
}  // namespace pastoso::session
