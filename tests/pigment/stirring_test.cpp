// Paint stirred into layers: what is known of homogeneous ones, and the ends of the scale of any.
#include "pigment/stirring.hpp"

#include <cmath>
#include <random>

#include <gtest/gtest.h>

namespace pastoso::pigment {
namespace {

using Layer = LayerOptics<double>;

void expect_near(const Layer& a, const Layer& b, double tolerance) {
    EXPECT_NEAR(a.reflectance, b.reflectance, tolerance);
    EXPECT_NEAR(a.transmittance, b.transmittance, tolerance);
    EXPECT_NEAR(a.reverse, b.reverse, tolerance);
}

class Stirring : public testing::Test {
  protected:
    double between(double low, double high) {
        return std::uniform_real_distribution(low, high)(random_);
    }
    /// From a glaze to a layer that still lets light through.
    OpticalThickness thickness() { return {std::exp(between(-5.0, 0.7)), std::exp(between(-4.0, 1.0))}; }

  private:
    std::mt19937 random_{11};
};

TEST_F(Stirring, FindsWhatAHomogeneousLayerIsMadeOf) {
    for (int i = 0; i < 2000; ++i) {
        const OpticalThickness made = thickness();
        const OpticalThickness found = optical_thickness(layer_optics(made.kh, made.sh));
        EXPECT_NEAR(found.kh, made.kh, 1e-4 * made.kh + 1e-5) << made.kh << " " << made.sh;
        EXPECT_NEAR(found.sh, made.sh, 1e-4 * made.sh + 1e-5) << made.kh << " " << made.sh;
    }
}

TEST_F(Stirring, MixesHomogeneousLayersByVolume) {
    for (int i = 0; i < 500; ++i) {
        const OpticalThickness one = thickness(), other = thickness();
        const double share = between(0.0, 1.0);
        const Layer expected = layer_optics((1.0 - share) * one.kh + share * other.kh,
                                            (1.0 - share) * one.sh + share * other.sh);
        expect_near(stirred(layer_optics(one.kh, one.sh), other, share), expected, 1e-4);
    }
}

TEST_F(Stirring, NothingChangesNothingAndAllIsTheOtherPaint) {
    for (int i = 0; i < 500; ++i) {
        const OpticalThickness upper = thickness(), lower = thickness(), other = thickness();
        const Layer layer = laid_over(layer_optics(upper.kh, upper.sh), layer_optics(lower.kh, 9.0));
        expect_near(stirred(layer, other, 0.0), layer, 1e-12);
        expect_near(stirred(layer, other, 1.0), layer_optics(other.kh, other.sh), 1e-12);
        expect_near(stirred(layer, other, 1e-3), layer, 0.02);
    }
}

TEST_F(Stirring, ClearAndOpaqueLayersStayWithinWhatLightCanDo) {
    for (const Layer& layer : {kClearLayer<double>, Layer{0.99, 0.0, 0.99}, Layer{0.0, 0.0, 0.0}})
        for (const double share : {0.0, 0.01, 0.5, 0.99, 1.0}) {
            const Layer found = stirred(layer, {0.3, 0.5}, share);
            EXPECT_GE(found.reflectance, 0.0);
            EXPECT_LE(found.reflectance + found.transmittance, 1.0 + 1e-3);
        }
}

/// In flecks it would be the mean of both, which is grey.
TEST_F(Stirring, BlueStirredIntoYellowIsGreen) {
    const OpticalThickness yellow_in_blue{4.0, 3.0}, yellow_in_green{0.1, 3.0};
    const OpticalThickness blue_in_blue{0.1, 1.0}, blue_in_green{0.6, 1.0}, blue_in_red{5.0, 1.0};
    const OpticalThickness yellow_in_red{0.02, 3.0};
    const auto half = [](const OpticalThickness& yellow, const OpticalThickness& blue) {
        return stirred(layer_optics(yellow.kh, yellow.sh), blue, 0.5).reflectance;
    };
    const double green = half(yellow_in_green, blue_in_green);
    EXPECT_GT(green, 1.6 * half(yellow_in_red, blue_in_red));
    EXPECT_GT(green, 1.4 * half(yellow_in_blue, blue_in_blue));
}

}  // namespace
}  // namespace pastoso::pigment
