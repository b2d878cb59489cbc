// Which bristles stand at the edges of clumps.
#include "brush/clumps.hpp"

#include <vector>

#include <gtest/gtest.h>

namespace pastoso::brush {
namespace {

constexpr double kRadius_mm = 0.5;

HandPose hand_to(double x, double y) {
    HandPose hand;
    hand.travel_x = x;
    hand.travel_y = y;
    return hand;
}

/// Bristles that touch at these places across a stroke to the right.
std::vector<BristlePose> bristles_at(const std::vector<double>& sides_mm) {
    std::vector<BristlePose> poses(sides_mm.size());
    for (std::size_t i = 0; i < poses.size(); ++i)
        poses[i] = {.down = true, .x_mm = 0.3 * static_cast<double>(i), .y_mm = sides_mm[i]};
    return poses;
}

TEST(Clumps, AreApartWhereNoFootprintReaches) {
    Clumps clumps;
    // From -1 to 0.75 no gap is wider than two radii; 2 is alone.
    clumps.find(bristles_at({0.0, 2.0, -1.0, 0.75}), hand_to(1.0, 0.0), kRadius_mm);
    EXPECT_DOUBLE_EQ(clumps.to_edge_mm(0), 0.75);
    EXPECT_DOUBLE_EQ(clumps.to_edge_mm(1), 0.0);
    EXPECT_DOUBLE_EQ(clumps.to_edge_mm(2), 0.0);
    EXPECT_DOUBLE_EQ(clumps.to_edge_mm(3), 0.0);
}

TEST(Clumps, EndWhereBristlesAreLifted) {
    Clumps clumps;
    std::vector<BristlePose> poses = bristles_at({0.0, 0.5, 1.0, 1.5, 2.0});
    clumps.find(poses, hand_to(1.0, 0.0), kRadius_mm);
    EXPECT_DOUBLE_EQ(clumps.to_edge_mm(2), 1.0);
    poses[1] = poses[3] = {};
    clumps.find(poses, hand_to(1.0, 0.0), kRadius_mm);
    EXPECT_DOUBLE_EQ(clumps.to_edge_mm(2), 1.0) << "two radii apart still meet";
    poses[2].y_mm = 1.01;
    clumps.find(poses, hand_to(1.0, 0.0), kRadius_mm);
    EXPECT_DOUBLE_EQ(clumps.to_edge_mm(2), 0.0);
}

TEST(Clumps, AreThoseAcrossTheTravel) {
    Clumps clumps;
    const std::vector<BristlePose> poses = bristles_at({0.0, 3.0, 6.0});
    clumps.find(poses, hand_to(1.0, 0.0), kRadius_mm);
    EXPECT_DOUBLE_EQ(clumps.to_edge_mm(1), 0.0);
    clumps.find(poses, hand_to(0.0, 1.0), kRadius_mm);
    EXPECT_DOUBLE_EQ(clumps.to_edge_mm(1), 0.3);
}

}  // namespace
}  // namespace pastoso::brush
