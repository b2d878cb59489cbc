#include "liquid/vessel/cup.hpp"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

namespace pastoso::liquid {
namespace {

TEST(Cup, DistancesAreNegativeWithinAndZeroOnItsSurfaces) {
    const Cup cup;
    EXPECT_LT(tea_distance_m(cup, {0.05F, 0.05F, 0.05F}), -0.03F);
    EXPECT_NEAR(tea_distance_m(cup, {0.05F, 0.05F, cup.floor_m}), 0.0F, 1e-8F);
    EXPECT_NEAR(tea_distance_m(cup, {0.05F, 0.05F, cup.level_m}), 0.0F, 1e-8F);
    EXPECT_NEAR(tea_distance_m(cup, {0.05F + cup.inner_radius_m(0.04F), 0.05F, 0.04F}), 0.0F, 1e-8F);
    EXPECT_NEAR(tea_distance_m(cup, {0.05F, 0.05F, cup.level_m + 0.002F}), 0.002F, 1e-8F);
}

TEST(Cup, TheWallsDistanceIsMeasuredAcrossIt) {
    const Cup cup;
    const float step = 0.001F, length = std::sqrt(1.0F + cup.slope * cup.slope);
    const float z = 0.05F, x = 0.05F + cup.inner_radius_m(z);
    EXPECT_NEAR(tea_distance_m(cup, {x + step / length, 0.05F, z - step * cup.slope / length}), step,
                1e-7F);
}

TEST(Cup, PointsOutsideAreBroughtWithinByTheMarginAndOthersLeftAlone) {
    const Cup cup;
    const float margin = 0.0005F;
    const glm::vec3 inside(0.05F, 0.06F, 0.04F);
    EXPECT_EQ(brought_within(cup, inside, margin), inside);
    // The normal is measured by differences of floats.
    const glm::vec3 below = brought_within(cup, {0.05F, 0.05F, -0.01F}, margin);
    EXPECT_NEAR(below.z, cup.floor_m + margin, 1e-6F);
    const glm::vec3 aside = brought_within(cup, {0.12F, 0.05F, 0.05F}, margin);
    EXPECT_NEAR(tea_distance_m(cup, aside), -margin, 1e-5F);
    const glm::vec3 corner = brought_within(cup, {0.12F, 0.05F, 0.12F}, margin);
    EXPECT_LT(tea_distance_m(cup, corner), 0.0F);
}

TEST(Cup, AStraightCupHoldsACylinder) {
    Cup cup;
    cup.slope = 0.0F;
    cup.floor_radius_m = 0.03F;
    // The sizes are floats.
    const double exact = std::numbers::pi * 0.03 * 0.03 * 0.084;
    EXPECT_NEAR(tea_volume_m3(cup), exact, 1e-6 * exact);
}

TEST(Cup, ItsLevelIsThatOfWhatFillsIt) {
    for (const float slope : {-0.3F, 0.0F, 0.1F, 0.8F}) {
        Cup cup;
        cup.slope = slope;
        for (const float level_m : {0.01F, 0.05F, 0.088F, 0.12F}) {
            if (cup.inner_radius_m(level_m) < 0.005F) continue;
            const double volume_m3 = tea_volume_m3(filled_to(cup, level_m));
            EXPECT_NEAR(level_at_volume_m(cup, volume_m3), level_m, 1e-7F) << slope;
        }
    }
    EXPECT_EQ(level_at_volume_m(Cup{}, 0.0), Cup{}.floor_m);
}

}  // namespace
}  // namespace pastoso::liquid
