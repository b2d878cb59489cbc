#include "pigment/unmixing.hpp"

#include "pigment/box.hpp"

#include <cmath>
#include <numeric>
#include <random>

#include <gtest/gtest.h>

namespace pastoso::pigment {
namespace {

std::vector<Coefficients> box() {
    std::vector<Coefficients> paints;
    for (const Pigment& pigment : default_box())
        paints.push_back(pigment.coefficients);
    return paints;
}

Coefficients mixture(const std::vector<Coefficients>& paints, const std::vector<double>& shares) {
    Coefficients sum{};
    for (int k = 0; k < kChannels; ++k) {
        double value = 0.0;
        for (std::size_t i = 0; i < paints.size(); ++i)
            value += shares[i] * paints[i][k];
        sum[k] = static_cast<float>(value);
    }
    return sum;
}

/// Leaving a paint out that nobody would miss moves the others by up to a hundredth.
constexpr double kShareTolerance = 0.01;

TEST(Unmixed, TellsTwoTubesAndTheirMedium) {
    const std::vector<Coefficients> paints = {{8, 4, 2, 1, 1, 1, 2, 2, 2, 2, 2, 2},
                                              {0, 0, 0, 0, 4, 8, 1, 1, 1, 1, 1, 1}};
    const Unmixed found = unmixed(mixture(paints, {0.5, 0.25}), paints);
    EXPECT_NEAR(found.shares[0], 0.5, 1e-7);  // coefficients are floats
    EXPECT_NEAR(found.shares[1], 0.25, 1e-7);
    EXPECT_LT(found.error, 1e-6);
}

TEST(Unmixed, ClearMediumHoldsNothing) {
    const Unmixed found = unmixed({}, box());
    EXPECT_EQ(found.shares, std::vector<double>(box().size()));
    EXPECT_EQ(found.error, 0.0);
}

TEST(Unmixed, WhatWasNotMixedOfThemIsFarOff) {
    const std::vector<Coefficients> paints = {{8, 4, 2, 1, 1, 1, 2, 2, 2, 2, 2, 2}};
    EXPECT_GT(unmixed({0, 0, 0, 0, 4, 8, 1, 1, 1, 1, 1, 1}, paints).error, 0.3);
    EXPECT_TRUE(unmixed({1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1}, {}).shares.empty());
}

TEST(Unmixed, FindsEveryPairOfTheBox) {
    const std::vector<Coefficients> paints = box();
    for (std::size_t a = 0; a < paints.size(); ++a) {
        for (std::size_t b = 0; b < paints.size(); ++b) {
            if (a == b) continue;
            std::vector<double> shares(paints.size());
            shares[a] = 0.6;
            shares[b] = 0.2;
            const Unmixed found = unmixed(mixture(paints, shares), paints);
            for (std::size_t i = 0; i < paints.size(); ++i)
                EXPECT_NEAR(found.shares[i], shares[i], kShareTolerance)
                    << default_box()[a].ci_name << " with " << default_box()[b].ci_name << ": "
                    << default_box()[i].ci_name;
        }
    }
}

TEST(Unmixed, FindsMixturesOfFourOutOfSixOnThePalette) {
    const std::vector<Coefficients> tubes = box();
    std::mt19937 random(7);
    std::uniform_real_distribution<double> part(0.05, 1.0);
    std::uniform_int_distribution<std::size_t> tube(0, tubes.size() - 1);
    for (int trial = 0; trial < 200; ++trial) {
        std::vector<Coefficients> paints;
        for (int i = 0; i < 6; ++i)
            paints.push_back(tubes[(tube(random) + static_cast<std::size_t>(i)) % tubes.size()]);
        std::vector<double> shares(paints.size());
        double sum = 0.0;
        for (int i = 0; i < 4; ++i)
            sum += shares[static_cast<std::size_t>(i)] = part(random);
        for (double& share : shares)
            share /= sum;
        const Coefficients wanted = mixture(paints, shares);
        const Unmixed found = unmixed(wanted, paints);
        EXPECT_LT(found.error, 0.001) << trial;
        const double total = std::accumulate(found.shares.begin(), found.shares.end(), 0.0);
        EXPECT_NEAR(total, 1.0, 0.05) << trial;
        for (const double share : found.shares)
            EXPECT_GE(share, 0.0);
    }
}

TEST(Unmixed, AThousandthOfNoiseBringNoOtherPaintIn) {
    const std::vector<Coefficients> paints = box();
    std::mt19937 random(3);
    std::uniform_real_distribution<float> noise(-0.0015F, 0.0015F);
    std::vector<double> shares(paints.size());
    shares[0] = 0.4;
    shares[15] = 0.6;
    Coefficients wanted = mixture(paints, shares);
    for (float& value : wanted)
        value *= 1.0F + noise(random);
    const Unmixed found = unmixed(wanted, paints);
    for (std::size_t i = 0; i < paints.size(); ++i)
        EXPECT_NEAR(found.shares[i], shares[i], kShareTolerance) << default_box()[i].ci_name;
}

}  // namespace
}  // namespace pastoso::pigment
