#include "core/elementary.hpp"

#include <cmath>

#include <gtest/gtest.h>

namespace pastoso::core {
namespace {

TEST(NaturalLog, IsThatOfTheMathsLibrary) {
    for (double x = 1e-9; x < 1e9; x *= 1.37)
        EXPECT_NEAR(natural_log(x), std::log(x), 1e-12 * std::max(1.0, std::abs(std::log(x)))) << x;
    EXPECT_EQ(natural_log(1.0), 0.0);
    EXPECT_NEAR(natural_log(1.0 + 1e-8) / std::log1p(1e-8), 1.0, 1e-7);
}

TEST(Exponential, IsThatOfTheMathsLibrary) {
    for (double x = -40.0; x < 40.0; x += 0.173)
        EXPECT_NEAR(exponential(x) / std::exp(x), 1.0, 1e-12) << x;
    EXPECT_EQ(exponential(0.0), 1.0);
}

}  // namespace
}  // namespace pastoso::core
