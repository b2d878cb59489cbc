#include "pigment/layer_optics.hpp"

#include <random>

#include <gtest/gtest.h>

namespace pastoso::pigment {
namespace {

using Layer = LayerOptics<double>;

/// Differences of doubles that were computed in another order.
constexpr double kRounding = 1e-8;

void expect_same(const Layer& a, const Layer& b, double tolerance) {
    EXPECT_NEAR(a.reflectance, b.reflectance, tolerance);
    EXPECT_NEAR(a.transmittance, b.transmittance, tolerance);
    EXPECT_NEAR(a.reverse, b.reverse, tolerance);
}

class RandomLayers : public testing::Test {
  protected:
    double between(double low, double high) {
        return std::uniform_real_distribution(low, high)(random_);
    }
    /// From clear to opaque, from black to white.
    double optical_thickness() { return std::exp(between(-9.0, 3.0)); }
    Layer layer() { return layer_optics(optical_thickness(), optical_thickness()); }

  private:
    std::mt19937 random_{7};
};

TEST_F(RandomLayers, OverAGroundAreWhatKubelkaSays) {
    for (int i = 0; i < 2000; ++i) {
        const double kh = optical_thickness(), sh = optical_thickness(), ground = between(0.0, 1.0);
        EXPECT_NEAR(reflectance_over(layer_optics(kh, sh), ground), layer_reflectance(kh, sh, ground),
                    kRounding)
            << kh << " " << sh << " " << ground;
    }
}

TEST_F(RandomLayers, OfOnePaintMakeOneThickerLayer) {
    for (int i = 0; i < 500; ++i) {
        const double kh = optical_thickness(), sh = optical_thickness(), share = between(0.0, 1.0);
        const Layer upper = layer_optics(share * kh, share * sh);
        const Layer lower = layer_optics((1.0 - share) * kh, (1.0 - share) * sh);
        // The absorption of 1e-9 that every layer gets counts twice here.
        expect_same(laid_over(upper, lower), layer_optics(kh, sh), 1e-4);
    }
}

TEST_F(RandomLayers, MayBeJoinedInAnyOrder) {
    for (int i = 0; i < 500; ++i) {
        const Layer a = layer(), b = layer(), c = layer();
        expect_same(laid_over(laid_over(a, b), c), laid_over(a, laid_over(b, c)), kRounding);
        const double ground = between(0.0, 1.0);
        EXPECT_NEAR(reflectance_over(laid_over(a, b), ground),
                    reflectance_over(a, reflectance_over(b, ground)), kRounding);
    }
}

TEST_F(RandomLayers, NeverGiveMoreLightThanTheyGet) {
    for (int i = 0; i < 500; ++i) {
        const Layer both =
            faded(laid_over(layer(), faded(layer(), between(0.0, 1.0))), between(0.0, 1.0));
        EXPECT_LE(both.reflectance + both.transmittance, 1.0 + kRounding);
        EXPECT_LE(both.reverse + both.transmittance, 1.0 + kRounding);
        EXPECT_GE(std::min({both.reflectance, both.transmittance, both.reverse}), 0.0);
    }
}

TEST_F(RandomLayers, FadedToNothingAreClearAndUnfadedTheSame) {
    for (int i = 0; i < 100; ++i) {
        const Layer some = layer();
        expect_same(faded(some, 0.0), kClearLayer<double>, 0.0);
        expect_same(faded(some, 1.0), some, 0.0);
        expect_same(laid_over(some, kClearLayer<double>), some, 0.0);
        expect_same(laid_over(kClearLayer<double>, some), some, 0.0);
    }
}

TEST_F(RandomLayers, TurnedOverStandOnTheirHeads) {
    const auto turned = [](const Layer& one) {
        return Layer{one.reverse, one.transmittance, one.reflectance};
    };
    for (int i = 0; i < 100; ++i) {
        const Layer a = layer(), b = laid_over(layer(), layer());
        expect_same(turned(laid_over(a, b)), laid_over(turned(b), turned(a)), kRounding);
    }
}

TEST(LayerOptics, OfSingleFloatsAreNearThoseOfDoubles) {
    std::mt19937 random(11);
    std::uniform_real_distribution<double> exponent(-9.0, 3.0);
    for (int i = 0; i < 2000; ++i) {
        const double kh = std::exp(exponent(random)), sh = std::exp(exponent(random));
        const auto exact = layer_optics(kh, sh);
        const auto single = layer_optics(static_cast<float>(kh), static_cast<float>(sh));
        // The error of the exponential, 1e-5, is the largest; a thin white layer magnifies it a little.
        EXPECT_NEAR(single.reflectance, exact.reflectance, 3e-5) << kh << " " << sh;
        EXPECT_NEAR(single.transmittance, exact.transmittance, 3e-5) << kh << " " << sh;
    }
}

TEST_F(RandomLayers, LaidInPartMixWhatIsSeen) {
    for (int i = 0; i < 1000; ++i) {
        const double outside = between(0.0, 0.96), share = between(0.0, 1.0), ground = between(0.0, 0.97);
        const double seen = through_surface(reflectance_over(laid_in_part(outside, share), ground));
        EXPECT_NEAR(seen, share * outside + (1.0 - share) * through_surface(ground), kRounding);
    }
}

TEST(LayerOptics, LaidInPartAreNothingAtAllOrOpaque) {
    expect_same(laid_in_part(0.4, 0.0), kClearLayer<double>, kRounding);
    EXPECT_EQ(laid_in_part(0.4, 1.0).transmittance, 0.0);
}

}  // namespace
}  // namespace pastoso::pigment
