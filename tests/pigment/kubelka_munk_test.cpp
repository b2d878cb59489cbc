#include "pigment/kubelka_munk.hpp"

#include <cmath>
#include <random>

#include <gtest/gtest.h>

namespace pastoso::pigment {
namespace {

/// Kubelka's hyperbolic solution, the textbook form.
double coth_form(double kh, double sh, double ground) {
    const double a = 1.0 + kh / sh;
    const double b = std::sqrt(a * a - 1.0);
    const double b_coth = b / std::tanh(b * sh);
    return (1.0 - ground * (a - b_coth)) / (a - ground + b_coth);
}

struct Layer {
    double kh, sh, ground;
};

/// Optical thicknesses spread evenly over the decades 1e-5 to 1e3.
Layer random_layer(std::mt19937& random) {
    std::uniform_real_distribution<double> share(0.0, 1.0);
    return {std::pow(10.0, -5.0 + 8.0 * share(random)), std::pow(10.0, -5.0 + 8.0 * share(random)),
            0.98 * share(random)};
}

TEST(KubelkaMunk, LayerEqualsTheHyperbolicForm) {
    std::mt19937 random(1);
    for (int i = 0; i < 200000; ++i) {
        const Layer layer = random_layer(random);
        // Beyond these ratios the floor on K/S acts, or a^2 - 1 of the textbook form loses its digits.
        if (layer.kh < 1.1e-5 * layer.sh || layer.kh > 1e4 * layer.sh || layer.sh < 1e-4) continue;
        EXPECT_NEAR(layer_reflectance(layer.kh, layer.sh, layer.ground),
                    coth_form(layer.kh, layer.sh, layer.ground), 1e-6)
            << layer.kh << " " << layer.sh << " " << layer.ground;
    }
}

TEST(KubelkaMunk, SinglePrecisionFollowsDouble) {
    std::mt19937 random(2);
    double largest = 0.0;
    for (int i = 0; i < 400000; ++i) {
        const Layer layer = random_layer(random);
        const auto kh = static_cast<float>(layer.kh);
        const auto sh = static_cast<float>(layer.sh);
        const auto ground = static_cast<float>(layer.ground);
        const double exact = layer_reflectance<double>(kh, sh, ground);
        largest = std::max(largest, std::abs(layer_reflectance(kh, sh, ground) - exact));
    }
    // A tenth of an 8-bit step of a screen is 4e-4; white on white loses the most digits, in 1 - r Rg.
    EXPECT_LE(largest, 3e-5);
}

TEST(KubelkaMunk, ReflectanceIsANumberFromZeroToOneForAnyLayer) {
    const float thicknesses[] = {0.0F, 1e-30F, 1e-9F,  1e-5F, 0.01F, 0.5F,
                                 1.0F, 7.0F,   100.0F, 1e3F,  1.6e4F};
    for (const float kh : thicknesses) {
        for (const float sh : thicknesses) {
            for (const float ground : {0.0F, 0.3F, 0.93F, 1.0F}) {
                const float reflectance = layer_reflectance(kh, sh, ground);
                EXPECT_GE(reflectance, 0.0F) << kh << " " << sh << " " << ground;
                EXPECT_LE(reflectance, 1.0001F) << kh << " " << sh << " " << ground;
            }
        }
    }
}

TEST(KubelkaMunk, NoPaintLeavesTheGroundExactly) {
    for (const float ground : {0.0F, 0.123F, 0.9F, 0.93F}) {
        EXPECT_EQ(layer_reflectance(0.0F, 0.0F, ground), ground);
    }
}

TEST(KubelkaMunk, ThickLayersHideTheGround) {
    for (const float ground : {0.0F, 0.9F}) {
        EXPECT_NEAR(layer_reflectance(20.0F, 40.0F, ground), opaque_reflectance(20.0F, 40.0F), 1e-6F);
    }
}

TEST(KubelkaMunk, ClearLayersFollowBeerLambertBothWays) {
    for (const float kh : {0.01F, 0.4F, 2.0F}) {
        EXPECT_NEAR(layer_reflectance(kh, 0.0F, 0.8F), 0.8 * std::exp(-2.0 * kh), 1e-6);
    }
}

TEST(KubelkaMunk, TwoThinLayersEqualOneOfBothTogether) {
    const double lower = layer_reflectance(0.3, 0.5, 0.9);
    EXPECT_NEAR(layer_reflectance(0.2, 1.0 / 3.0, lower), layer_reflectance(0.5, 5.0 / 6.0, 0.9), 1e-8);
}

TEST(KubelkaMunk, OpaqueReflectanceOfEqualAbsorptionAndScattering) {
    EXPECT_NEAR(opaque_reflectance(1.0, 1.0), 2.0 - std::sqrt(3.0), 1e-15);
    EXPECT_EQ(opaque_reflectance(1.0, 0.0), 0.0);
    EXPECT_EQ(opaque_reflectance(0.0, 5.0), 1.0);
}

TEST(KubelkaMunk, ExponentialIsAccurateAndExactAtZero) {
    EXPECT_EQ(exp_of_negative(0.0F), 1.0F);
    for (float x = 0.0F; x > -80.0F; x -= 0.0137F) {
        const double exact = std::exp(static_cast<double>(x));
        // The rounding of x log2(e), 6e-8 of at most 115, is the relative error of the result.
        EXPECT_NEAR(exp_of_negative(x), exact, 1e-5 * exact + 1e-38);
        EXPECT_NEAR(exp_of_negative(x), exact, 1e-7) << x;
    }
    EXPECT_LT(exp_of_negative(-1e30F), 1e-37F);
}

TEST(KubelkaMunk, SurfaceReturnsLessThanEntersAndKeepsBlack) {
    EXPECT_EQ(through_surface(0.0), 0.0);
    EXPECT_NEAR(through_surface(1.0), 1.0 - kExternalReflection, 1e-15);
    EXPECT_NEAR(through_surface(0.5), 0.97 * 0.35 * 0.5 / (1.0 - 0.65 * 0.5), 1e-15);
}

}  // namespace
}  // namespace pastoso::pigment
