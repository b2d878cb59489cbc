// Six bands against the full spectrum: random mixtures of the palette, opaque, in every light.
#include "pigment/adaptation.hpp"
#include "pigment/kubelka_munk.hpp"
#include "pigment/lab.hpp"
#include "pigment/observer.hpp"
#include "pigment/palette.hpp"
#include "pigment/viewing.hpp"

#include <algorithm>
#include <random>

#include <gtest/gtest.h>

namespace pastoso::pigment {
namespace {

struct Mixture {
    Coefficients coefficients{};
    Spectrum absorption{}, scattering{};
};

/// One to five pigments in parts spread over two decades, with ten to a thousand parts of white when
/// tinted.
Mixture random_mixture(std::mt19937& random, bool tinted) {
    const std::vector<Pigment>& palette = bundled_palette();
    std::uniform_int_distribution<std::size_t> which(0, palette.size() - 1);
    std::uniform_real_distribution<double> share(0.0, 1.0);
    std::vector<std::pair<const Pigment*, double>> recipe;
    const int count = std::uniform_int_distribution<int>(1, 5)(random);
    for (int i = 0; i < count; ++i) {
        recipe.emplace_back(&palette[which(random)], std::pow(10.0, 2.0 * share(random)));
    }
    if (tinted) {
        recipe.emplace_back(&find_pigment("PW6"), std::pow(10.0, 1.0 + 2.0 * share(random)));
    }
    std::vector<Portion> portions;
    Mixture mixture;
    for (const auto& [pigment, parts] : recipe) {
        portions.push_back({pigment->coefficients, parts});
        for (int i = 0; i < kSpectralSamples; ++i) {
            mixture.absorption[i] += parts * pigment->absorption_per_mm[i];
            mixture.scattering[i] += parts * pigment->scattering_per_mm[i];
        }
    }
    mixture.coefficients = mix(portions);
    return mixture;
}

Lab lab_of(const Xyz& adapted) {
    return lab(adapted, white_xyz(kD65White));
}

/// From the full spectrum, by an eye adapted to the light.
Lab spectral_colour(const Mixture& mixture, const Spectrum& power) {
    Spectrum reflectance{};
    for (int i = 0; i < kSpectralSamples; ++i) {
        reflectance[i] =
            through_surface(opaque_reflectance(mixture.absorption[i], mixture.scattering[i]));
    }
    const Matrix3 adaptation = bradford(white_under(power), white_xyz(kD65White));
    return lab_of(transformed(adaptation, tristimulus(reflectance, power)));
}

Lab band_colour(const Mixture& mixture, const Viewing& viewing) {
    Bands reflectance{};
    for (int band = 0; band < kBands; ++band) {
        reflectance[band] = through_surface(
            opaque_reflectance(mixture.coefficients[band], mixture.coefficients[kBands + band]));
    }
    const LinearRgb rgb = seen_colour(reflectance, viewing.to_rgb);
    return lab_of(transformed(xyz_from_linear(viewing.space), {rgb[0], rgb[1], rgb[2]}));
}

struct Differences {
    double mean = 0.0, percentile_95 = 0.0;
};

/// Which of the mixtures have white in them.
enum class Tinted { None, EverySecond, All };

Differences measure(const Illuminant& light, const Viewing& viewing, Tinted tinted) {
    std::mt19937 random(4000);
    std::vector<double> differences(4000);
    Differences result;
    bool white = tinted != Tinted::None;
    for (double& difference : differences) {
        const Mixture mixture = random_mixture(random, white);
        if (tinted == Tinted::EverySecond) white = !white;
        difference = ciede2000(spectral_colour(mixture, light.power), band_colour(mixture, viewing));
        result.mean += difference / 4000.0;
    }
    std::sort(differences.begin(), differences.end());
    result.percentile_95 = differences[3800];
    return result;
}

struct Limits {
    const char* light;
    double tint_mean, tint_95, deep_mean, deep_95;
};

// The design asks for 0.45 and 1.3 over mixtures and tints together under D65, for a mean of 0.55 under
// A; 1 is the smallest difference that is seen side by side. Measured in tints: D65 0.35, 0.92; D50
// 0.34, 0.94; A 0.39, 1.12; LED 0.35, 0.89. In deep mixtures without white the edges of strong pigments
// fall between the windows: D65 0.52, 1.38; D50 0.52, 1.43; A 0.61, 1.89; LED 0.49, 1.36. Windows made
// for those alone leave 0.49 under D65, and 0.40 in tints.
constexpr Limits kLimits[] = {{"D65", 0.4, 1.1, 0.55, 1.5},
                              {"D50", 0.4, 1.1, 0.55, 1.5},
                              {"A", 0.45, 1.3, 0.7, 2.1},
                              {"LED", 0.4, 1.1, 0.55, 1.5}};

class BandsUnder : public testing::TestWithParam<Limits> {};

TEST_P(BandsUnder, SixGiveTheColoursOfTheSpectrumInTints) {
    const Illuminant light = find_illuminant(GetParam().light);
    const Differences differences = measure(light, viewing_under(light), Tinted::All);
    EXPECT_LE(differences.mean, GetParam().tint_mean);
    EXPECT_LE(differences.percentile_95, GetParam().tint_95);
}

TEST_P(BandsUnder, SixGiveTheColoursOfTheSpectrumInDeepMixtures) {
    const Illuminant light = find_illuminant(GetParam().light);
    const Differences differences = measure(light, viewing_under(light), Tinted::None);
    EXPECT_LE(differences.mean, GetParam().deep_mean);
    EXPECT_LE(differences.percentile_95, GetParam().deep_95);
}

INSTANTIATE_TEST_SUITE_P(Lights, BandsUnder, testing::ValuesIn(kLimits),
                         [](const auto& instance) { return std::string(instance.param.light); });

TEST(Bands, SixGiveTheColoursOfMixturesAndTintsTogether) {
    const auto under = [](const char* name) {
        const Illuminant light = find_illuminant(name);
        return measure(light, viewing_under(light), Tinted::EverySecond);
    };
    // Every second one a tint, all pigments of the palette: the design's 0.45 and 1.3 by day and 0.55
    // under A. It depends on what is mixed: sixteen strong pigments alone, without earths, give 0.68,
    // 1.71 and 0.80.
    const Differences by_day = under("D65");
    EXPECT_LE(by_day.mean, 0.45);
    EXPECT_LE(by_day.percentile_95, 1.3);
    EXPECT_LE(under("A").mean, 0.55);
}

TEST(Bands, AnotherLightIsNoWashOverThePictureOfDaylight) {
    // What adapting a D65 picture to the lamp would show is the D65 picture itself.
    const Illuminant lamp = find_illuminant("A");
    EXPECT_GT(measure(lamp, Viewing{}, Tinted::All).mean,
              3.0 * measure(lamp, viewing_under(lamp), Tinted::All).mean);
}

TEST(Bands, DisplayP3ShowsTheSameColours) {
    const Illuminant light = find_illuminant("LED");
    const double srgb = measure(light, viewing_under(light), Tinted::All).mean;
    const double p3 = measure(light, viewing_under(light, WorkingSpace::DisplayP3), Tinted::All).mean;
    // Only the rounding of the matrix to single precision differs.
    EXPECT_NEAR(p3, srgb, 1e-4);
}

}  // namespace
}  // namespace pastoso::pigment
