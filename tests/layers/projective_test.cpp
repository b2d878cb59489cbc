#include "layers/projective.hpp"

#include "core/random.hpp"

#include <gtest/gtest.h>

namespace pastoso::layers {
namespace {

using grid::Point;

/// Rounding of a few products of numbers about 100.
constexpr double kRounding = 1e-9;

void expect_near(const Point& place, const Point& wanted) {
    EXPECT_NEAR(place.x, wanted.x, kRounding);
    EXPECT_NEAR(place.y, wanted.y, kRounding);
}

/// Corners of the square from (0, 0) to (100, 100), each taken up to 40 into it.
Corners within_square(std::uint32_t seed) {
    const auto in = [&](std::uint32_t k) { return 40.0 * core::uniform_noise(k, seed); };
    return {{{in(0), in(1)},
             {100.0 - in(2), in(3)},
             {100.0 - in(4), 100.0 - in(5)},
             {in(6), 100.0 - in(7)}}};
}

TEST(ProjectiveMap, TakesCornersToCorners) {
    for (std::uint32_t seed = 1; seed < 40; ++seed) {
        const Corners corners = within_square(seed);
        ASSERT_TRUE(bends_outwards(corners)) << seed;
        const Projective map = onto_corners({3.0, -7.0}, 50.0, 21.0, corners);
        const Point from[] = {{3.0, -7.0}, {53.0, -7.0}, {53.0, 14.0}, {3.0, 14.0}};
        double farthest = 0.0;
        for (int k = 0; k < 4; ++k) {
            expect_near(map(from[k].x, from[k].y), corners[k]);
            farthest = std::max(farthest, map.depth(from[k].x, from[k].y));
        }
        EXPECT_NEAR(farthest, 1.0, kRounding);
    }
}

TEST(ProjectiveMap, KeepsLinesStraight) {
    const Corners corners = within_square(5);
    const Projective map = onto_corners({0.0, 0.0}, 10.0, 10.0, corners);
    const Point crossing = map(5.0, 5.0);
    for (const int k : {0, 1}) {
        const Point &from = corners[k], &to = corners[k + 2];
        const double beside =
            (to.x - from.x) * (crossing.y - from.y) - (to.y - from.y) * (crossing.x - from.x);
        EXPECT_NEAR(beside, 0.0, 1e-7) << "where the diagonals cross, they cross afterwards";
    }
}

TEST(ProjectiveMap, AnInverseTakesBackAndItsDepthIsTheInverse) {
    for (std::uint32_t seed = 1; seed < 20; ++seed) {
        const Projective map = onto_corners({3.0, -7.0}, 50.0, 21.0, within_square(seed));
        const Point there = map(17.0, 4.5);
        expect_near(inverse(map)(there.x, there.y), {17.0, 4.5});
        EXPECT_NEAR(inverse(map).depth(there.x, there.y) * map.depth(17.0, 4.5), 1.0, kRounding);
        expect_near(followed_by(map, inverse(map))(31.0, 2.0), {31.0, 2.0});
    }
}

TEST(ProjectiveMap, OfAParallelogramIsAffine) {
    const Projective map = onto_corners({2.0, 3.0}, 10.0, 20.0, {{{0, 0}, {20, 5}, {22, 45}, {2, 40}}});
    EXPECT_TRUE(map.is_affine());
    expect_near(map(12.0, 13.0), {21.0, 25.0});
    const Steps steps = steps_at(map, 900.0, -30.0);
    expect_near(steps.right, {2.0, 0.5});
    expect_near(steps.down, {0.1, 2.0});
}

TEST(ProjectiveMap, StepsAreWhatShortWaysBecome) {
    const Projective map = onto_corners({0.0, 0.0}, 80.0, 60.0, within_square(9));
    constexpr double kStep = 1e-5;
    const Steps steps = steps_at(map, 33.0, 12.0);
    const Point here = map(33.0, 12.0), right = map(33.0 + kStep, 12.0), down = map(33.0, 12.0 + kStep);
    // The curvature is some 0.01.
    EXPECT_NEAR(steps.right.x, (right.x - here.x) / kStep, 1e-5);
    EXPECT_NEAR(steps.right.y, (right.y - here.y) / kStep, 1e-5);
    EXPECT_NEAR(steps.down.x, (down.x - here.x) / kStep, 1e-5);
    EXPECT_NEAR(steps.down.y, (down.y - here.y) / kStep, 1e-5);
}

TEST(ProjectiveMap, OnlyWhatBendsOutwardsIsAnArea) {
    EXPECT_TRUE(bends_outwards({{{0, 0}, {4, 0}, {4, 4}, {0, 4}}}));
    EXPECT_TRUE(bends_outwards({{{4, 0}, {0, 0}, {0, 4}, {4, 4}}})) << "mirrored";
    EXPECT_FALSE(bends_outwards({{{0, 0}, {4, 4}, {4, 0}, {0, 4}}})) << "crosses itself";
    EXPECT_FALSE(bends_outwards({{{0, 0}, {4, 0}, {1, 1}, {0, 4}}})) << "bends inwards";
    EXPECT_FALSE(bends_outwards({{{0, 0}, {4, 0}, {2, 2}, {0, 4}}})) << "goes straight on";
    EXPECT_FALSE(bends_outwards({{{0, 0}, {4, 0}, {4, 0}, {0, 4}}})) << "two corners are one";
    EXPECT_FALSE(bends_outwards({{{0, 0}, {1, 0}, {2, 0}, {3, 0}}}));
    EXPECT_FALSE(bends_outwards({{{1, 1}, {1, 1}, {1, 1}, {1, 1}}}));
}

}  // namespace
}  // namespace pastoso::layers
