#include "grid/bspline.hpp"

#include <cmath>
#include <numeric>
#include <vector>

#include <gtest/gtest.h>

namespace {

using pastoso::grid::bspline_weights;
using pastoso::grid::BsplineWeights;
using pastoso::grid::kPrefilterTaps;

constexpr float kPlaces[] = {0.0F, 0.1F, 0.25F, 0.5F, 0.77F, 0.999F};

/// Weights are sums of a few floats below 1: their rounding is some 1e-7.
constexpr double kRounding = 3e-7;

double moment(const std::array<float, 4>& weights, double t, int power) {
    double sum = 0.0;
    for (int k = 0; k < 4; ++k)
        sum += weights[k] * std::pow(k - 1 - t, power);
    return sum;
}

TEST(BsplineWeights, ReproduceConstantsAndLines) {
    for (const float t : kPlaces) {
        const BsplineWeights weights = bspline_weights(t);
        EXPECT_NEAR(moment(weights.value, t, 0), 1.0, kRounding);
        EXPECT_NEAR(moment(weights.value, t, 1), 0.0, kRounding);
        EXPECT_NEAR(moment(weights.slope, t, 0), 0.0, kRounding);
        EXPECT_NEAR(moment(weights.slope, t, 1), 1.0, kRounding);
        EXPECT_NEAR(moment(weights.bend, t, 0), 0.0, kRounding);
        EXPECT_NEAR(moment(weights.bend, t, 1), 0.0, kRounding);
        EXPECT_NEAR(moment(weights.bend, t, 2), 2.0, 10.0 * kRounding);
    }
}

TEST(BsplineWeights, HaveTheSplinesVariance) {
    // The cubic B-spline has variance 1/3, so weights applied to x^2 add 1/3 at every place.
    for (const float t : kPlaces)
        EXPECT_NEAR(moment(bspline_weights(t).value, t, 2), 1.0 / 3.0, 1e-6);
}

TEST(BsplineWeights, AtACoefficientAreOneFourOneSixths) {
    const BsplineWeights weights = bspline_weights(0.0F);
    EXPECT_FLOAT_EQ(weights.value[0], 1.0F / 6.0F);
    EXPECT_FLOAT_EQ(weights.value[1], 4.0F / 6.0F);
    EXPECT_FLOAT_EQ(weights.value[2], 1.0F / 6.0F);
    EXPECT_FLOAT_EQ(weights.value[3], 0.0F);
}

TEST(BsplineWeights, AreMirrored) {
    for (const float t : kPlaces) {
        const BsplineWeights weights = bspline_weights(t);
        const BsplineWeights mirrored = bspline_weights(1.0F - t);
        for (int k = 0; k < 4; ++k) {
            EXPECT_NEAR(weights.value[k], mirrored.value[3 - k], kRounding);
            EXPECT_NEAR(weights.slope[k], -mirrored.slope[3 - k], kRounding);
            EXPECT_NEAR(weights.bend[k], mirrored.bend[3 - k], kRounding);
        }
    }
}

TEST(BsplineWeights, SlopeIsTheDerivativeOfValue) {
    constexpr float kStep = 1.0F / 64.0F;
    for (const float t : {0.1F, 0.3F, 0.5F, 0.7F, 0.9F}) {
        const BsplineWeights weights = bspline_weights(t);
        for (int k = 0; k < 4; ++k) {
            const float difference =
                (bspline_weights(t + kStep).value[k] - bspline_weights(t - kStep).value[k]) /
                (2.0F * kStep);
            // A central difference of a cubic errs by step^2/6 times its third derivative, at most 3.
            EXPECT_NEAR(weights.slope[k], difference, 0.5F * kStep * kStep + 1e-5F);
        }
    }
}

TEST(Prefilter, KeepsConstantsAndIsSymmetric) {
    EXPECT_NEAR(std::accumulate(kPrefilterTaps.begin(), kPrefilterTaps.end(), 0.0), 1.0, kRounding);
    EXPECT_EQ(kPrefilterTaps[0], kPrefilterTaps[4]);
    EXPECT_EQ(kPrefilterTaps[1], kPrefilterTaps[3]);
}

/// The largest error of the spline's cell means for the cell means of a cosine with `cells` cells a
/// wave, relative to the cosine's. The mean of the cubic B-spline over a cell has the weights (1, 76,
/// 230, 76, 1)/384 of the coefficients around it.
double mean_error(int cells) {
    std::vector<double> means(cells);
    const double wave_number = 2.0 * std::acos(-1.0) / cells;
    for (int i = 0; i < cells; ++i)
        means[i] = std::cos(wave_number * i);
    const auto filtered = [&](const std::vector<double>& values, const std::array<double, 5>& taps) {
        std::vector<double> result(cells, 0.0);
        for (int i = 0; i < cells; ++i) {
            for (int k = 0; k < 5; ++k)
                result[i] += taps[k] * values[(i + k - 2 + cells) % cells];
        }
        return result;
    };
    std::array<double, 5> prefilter{};
    std::copy(kPrefilterTaps.begin(), kPrefilterTaps.end(), prefilter.begin());
    const std::array<double, 5> cell_mean = {1.0 / 384, 76.0 / 384, 230.0 / 384, 76.0 / 384, 1.0 / 384};
    const std::vector<double> restored = filtered(filtered(means, prefilter), cell_mean);
    double error = 0.0;
    for (int i = 0; i < cells; ++i)
        error = std::max(error, std::abs(restored[i] - means[i]));
    return error;
}

TEST(Prefilter, CellMeansReturnToSixthOrder) {
    // 10 and 20 cells a wave: the error is well above a float's rounding (1e-7) and well in the
    // asymptote.
    const double order = std::log2(mean_error(10) / mean_error(20));
    EXPECT_NEAR(order, 6.0, 0.3);
    EXPECT_LT(mean_error(20), 2e-5);
}

TEST(Prefilter, TheSplinesCellMeanWeightsAreItsIntegral) {
    // Checks the five weights used above: the mean over the cell around coefficient 0 by Simpson's rule,
    // which is exact for cubics, on both halves of the cell.
    std::array<double, 5> means{};
    for (int half = 0; half < 2; ++half) {
        for (int node = 0; node < 3; ++node) {
            const double weight = (node == 1 ? 4.0 : 1.0) / 12.0;
            const auto value =
                bspline_weights(static_cast<float>((half == 0 ? 0.5 : 0.0) + 0.25 * node)).value;
            for (int k = 0; k < 4; ++k)
                means[k + half] += weight * value[k];
        }
    }
    const std::array<double, 5> expected = {1.0 / 384, 76.0 / 384, 230.0 / 384, 76.0 / 384, 1.0 / 384};
    for (int k = 0; k < 5; ++k)
        EXPECT_NEAR(means[k], expected[k], kRounding);
}

}  // namespace
