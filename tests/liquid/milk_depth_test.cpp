#include "liquid/tea/milk_depth.hpp"

#include <cmath>

#include <gtest/gtest.h>

namespace pastoso::liquid {
namespace {

constexpr grid::BoxShape kShape{12, 12, 12, 0.01F};

TEST(MilkDepth, StraightUpItIsTheSumOfWhatLiesAbove) {
    grid::BoxField share(kShape);
    for (int k = 0; k < 12; ++k)
        share.at(4, 5, k) = 0.1F * static_cast<float>(k);
    const grid::BoxField depth_m = milk_depth_m(share, {0.0F, 0.0F, 3.0F});
    float above = 0.0F;
    for (int k = 11; k >= 0; --k) {
        EXPECT_NEAR(depth_m.at(4, 5, k), 0.01F * (above + 0.05F * static_cast<float>(k)), 1e-6F);
        EXPECT_EQ(depth_m.at(3, 5, k), 0.0F);
        above += 0.1F * static_cast<float>(k);
    }
}

TEST(MilkDepth, AslantItIsTheWayThroughEvenMilk) {
    grid::BoxField share(kShape);
    for (int k = 2; k < 8; ++k)  // a layer over all of the box
        for (int j = 0; j < 12; ++j)
            for (int i = 0; i < 12; ++i)
                share.at(i, j, k) = 0.5F;
    const glm::vec3 way(0.3F, -0.2F, 1.0F);
    const float long_m = 0.01F * std::sqrt(0.09F + 0.04F + 1.0F);
    const grid::BoxField depth_m = milk_depth_m(share, way);
    // Trapezoids: what half a cell above the layer adds is missing within it. Layer by layer the
    // interpolation lets in a little of the emptiness beyond the box.
    for (int k = 2; k < 8; ++k)
        EXPECT_NEAR(depth_m.at(5, 6, k), 0.5F * long_m * (static_cast<float>(7 - k) + 0.5F), 1e-5F);
    EXPECT_NEAR(depth_m.at(5, 6, 0), 3.0F * long_m, 1e-5F);
}

TEST(MilkDepth, AHalvedFieldKeepsItsMeans) {
    grid::BoxField field(kShape);
    field.at(4, 7, 9) = 8.0F;
    field.at(5, 6, 8) = 16.0F;
    const grid::BoxField coarse = halved(field);
    EXPECT_EQ(coarse.shape(), (grid::BoxShape{6, 6, 6, 0.02F}));
    EXPECT_EQ(coarse.at(2, 3, 4), 3.0F);
}

}  // namespace
}  // namespace pastoso::liquid
