// Elements of a row that lie side by side do together what one of them does in its middle.
#include "brush/lane_weight.hpp"

#include "brush/cell_mean.hpp"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

namespace pastoso::brush {
namespace {

TEST(LaneWeight, IsTheMeanOverACell) {
    constexpr double kLane_mm = 0.24, kCell_mm = 0.125;
    const double core = lane_core(kLane_mm, kCell_mm);
    const double reach_mm = kLane_mm / core;
    EXPECT_NEAR(reach_mm, kLane_mm + 0.5 * kCell_mm, 1e-12);
    for (const double x_mm : {0.0, 0.03, -0.1, 0.2, 0.27, -0.3}) {
        constexpr int kParts = 1000;
        double mean = 0.0;
        for (int i = 0; i < kParts; ++i) {
            const double part_mm = x_mm + kCell_mm * ((i + 0.5) / kParts - 0.5);
            mean += std::max(0.0, 1.0 - std::abs(part_mm) / kLane_mm) / kParts;
        }
        EXPECT_NEAR(lane_weight(static_cast<float>(x_mm / reach_mm), static_cast<float>(core)), mean,
                    1e-5);
    }
    EXPECT_EQ(lane_weight(1.0F, static_cast<float>(core)), 0.0F);
}

TEST(LaneWeight, OfNeighboursAddsUpToOne) {
    for (const float core : {0.3F, 0.5F, 0.8F, 0.97F}) {
        for (float s = 0.0F; s < core; s += 0.03F) {
            float sum = 0.0F;
            for (int i = -4; i <= 4; ++i)
                sum += lane_weight(s + static_cast<float>(i) * core, core);
            EXPECT_NEAR(sum, 1.0F, 1e-5F) << "core " << core << ", s " << s;
        }
    }
}

TEST(LaneShare, OfTwoNeighboursIsThatOfOne) {
    for (const float u : {0.0F, 0.1F, 0.5F, 0.8F}) {
        EXPECT_FLOAT_EQ(lane_share(u, 0.0F), 0.0F);
        EXPECT_NEAR(lane_share(u, 1.0F), u, 1e-6F);
        for (const float weight : {0.1F, 0.25F, 0.5F}) {
            const float left = (1.0F - lane_share(u, weight)) * (1.0F - lane_share(u, 1.0F - weight));
            EXPECT_NEAR(left, 1.0F - u, 0.03F * u) << "u " << u << ", weight " << weight;
        }
    }
    EXPECT_NEAR(lane_share(1.0F, 1.0F), 8.0F / 9.0F, 1e-6F);
}

}  // namespace
}  // namespace pastoso::brush
