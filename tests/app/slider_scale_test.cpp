#include "panels/parts/slider_scale.hpp"

#include <gtest/gtest.h>

namespace pastoso::panels {
namespace {

TEST(SliderScale, GoesByEqualDifferences) {
    const SliderScale scale{-1.0, 3.0};
    EXPECT_EQ(scale.value_at(0), -1.0);
    EXPECT_EQ(scale.value_at(SliderScale::kSteps / 4), 0.0);
    EXPECT_EQ(scale.value_at(SliderScale::kSteps), 3.0);
    EXPECT_EQ(scale.step_of(1.0), SliderScale::kSteps / 2);
}

TEST(SliderScale, GoesByEqualFactors) {
    const SliderScale scale{0.01, 100.0, true};
    EXPECT_DOUBLE_EQ(scale.value_at(0), 0.01);
    EXPECT_DOUBLE_EQ(scale.value_at(SliderScale::kSteps / 2), 1.0);
    EXPECT_DOUBLE_EQ(scale.value_at(SliderScale::kSteps), 100.0);
    EXPECT_EQ(scale.step_of(10.0), 3 * SliderScale::kSteps / 4);
}

TEST(SliderScale, EveryStepIsThatOfItsValue) {
    for (const SliderScale& scale : {SliderScale{0.0, 1.0}, {-5.0, 0.25}, {1e-6, 1.0, true}})
        for (int step = 0; step <= SliderScale::kSteps; ++step)
            EXPECT_EQ(scale.step_of(scale.value_at(step)), step);
}

TEST(SliderScale, BeyondItsEndsIsTheEnd) {
    const SliderScale even{0.0, 1.0}, logarithmic{1.0, 10.0, true};
    EXPECT_EQ(even.step_of(7.0), SliderScale::kSteps);
    EXPECT_EQ(even.step_of(-7.0), 0);
    EXPECT_EQ(logarithmic.step_of(0.0), 0);
    EXPECT_EQ(logarithmic.step_of(1e9), SliderScale::kSteps);
}

}  // namespace
}  // namespace pastoso::panels
