#include "core/lane_power.hpp"

#include <cmath>

#include <gtest/gtest.h>

namespace pastoso::core::lanes {
namespace {

using Four = Lanes<float, 4>;

TEST(CubeRoot, AndItsInverseAreThoseOfTheMathsLibrary) {
    for (float x = 1e-30F; x < 1e30F; x *= 1.37F) {
        EXPECT_NEAR(cube_root(x) / std::cbrt(x), 1.0F, 1e-6F) << x;
        EXPECT_NEAR(inverse_cube_root(x) * std::cbrt(x), 1.0F, 5e-7F) << x;
    }
}

TEST(CubeRoot, IsTheSameInLanes) {
    for (float x = 1e-30F; x < 1e30F; x *= 1.37F) {
        const float others[] = {x, 1.1F * x, 1.2F * x, 1.3F * x};
        const Four root = cube_root(Four(others[0], others[1], others[2], others[3])),
                   inverse = inverse_cube_root(Four(others[0], others[1], others[2], others[3]));
        for (int lane = 0; lane < 4; ++lane) {
            EXPECT_EQ(root[lane], cube_root(others[lane])) << others[lane];
            EXPECT_EQ(inverse[lane], inverse_cube_root(others[lane])) << others[lane];
        }
    }
}

}  // namespace
}  // namespace pastoso::core::lanes
