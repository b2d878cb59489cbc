#include "core/random.hpp"

#include <cmath>
#include <set>

#include <gtest/gtest.h>

namespace {

using pastoso::core::scramble;
using pastoso::core::uniform_noise;

TEST(Random, ScrambleIsABijection) {
    std::set<std::uint32_t> outputs;
    for (std::uint32_t x = 0; x < 100000; ++x)
        outputs.insert(scramble(x));
    EXPECT_EQ(outputs.size(), 100000U);
}

TEST(Random, NoiseHasTheMeanAndVarianceOfAUniformNumber) {
    constexpr int kCount = 100000;
    double sum = 0.0;
    double sum_of_squares = 0.0;
    for (std::uint32_t i = 0; i < kCount; ++i) {
        const double value = uniform_noise(i, 42);
        ASSERT_GE(value, 0.0);
        ASSERT_LT(value, 1.0);
        sum += value;
        sum_of_squares += value * value;
    }
    const double mean = sum / kCount;
    // The standard error of the mean is 1/sqrt(12 n) = 0.0009; the sequence is fixed, so four of them
    // do.
    EXPECT_NEAR(mean, 0.5, 0.0037);
    EXPECT_NEAR(sum_of_squares / kCount - mean * mean, 1.0 / 12.0, 0.002);
}

/// Correlation of noise at index i, stream s with noise at (i + di, s + ds).
double correlation(std::uint32_t di, std::uint32_t ds) {
    constexpr int kCount = 100000;
    double sum = 0.0;
    for (std::uint32_t i = 0; i < kCount; ++i) {
        sum += (uniform_noise(i, 5) - 0.5) * (uniform_noise(i + di, 5 + ds) - 0.5);
    }
    return 12.0 * sum / kCount;
}

TEST(Random, NeighbouringIndicesAndStreamsAreUnrelated) {
    // Four standard errors, 4/sqrt(n).
    EXPECT_NEAR(correlation(1, 0), 0.0, 0.0127);
    EXPECT_NEAR(correlation(0, 1), 0.0, 0.0127);
    EXPECT_NEAR(correlation(1, 1), 0.0, 0.0127);
}

TEST(Random, GivesTheSameNumbersEverywhere) {
    EXPECT_EQ(scramble(1), 1753845952U);
    EXPECT_EQ(uniform_noise(3, 7), uniform_noise(3, 7));
}

}  // namespace
