#include "pigment/rgb_paint.hpp"

#include "pigment/appearance.hpp"
#include "pigment/hex_colour.hpp"
#include "pigment/kubelka_munk.hpp"
#include "pigment/lab.hpp"
#include "pigment/palette.hpp"
#include "pigment/smooth_bands.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

namespace pastoso::pigment {
namespace {

RgbPaint paint(const char* hex) {
    return rgb_paint(decoded(*parse_hex_colour(hex)));
}

LinearRgb mixed(std::initializer_list<std::pair<const char*, double>> recipe) {
    std::vector<Portion> portions;
    for (const auto& [hex, parts] : recipe)
        portions.push_back({paint(hex).coefficients, parts});
    return masstone(mix(portions));
}

/// Red, green and blue of a mixture of equal parts, each within `tolerance` of 255 steps.
void expect_mixture(const char* first, const char* second, const Srgb8& expected, int tolerance) {
    const Srgb8 colour = encoded(mixed({{first, 1.0}, {second, 1.0}}));
    for (int i = 0; i < 3; ++i) {
        EXPECT_LE(std::abs(colour[i] - expected[i]), tolerance)
            << first << " and " << second << " make " << hex_colour(colour);
    }
}

/// Nine levels of red, green and blue each.
std::vector<LinearRgb> colour_grid() {
    std::vector<LinearRgb> grid;
    const auto level = [](int i) { return static_cast<float>(decode_srgb(i / 8.0)); };
    for (int r = 0; r < 9; ++r) {
        for (int g = 0; g < 9; ++g) {
            for (int b = 0; b < 9; ++b)
                grid.push_back({level(r), level(g), level(b)});
        }
    }
    return grid;
}

TEST(RgbPaint, HasTheColourItWasMadeFor) {
    int exact = 0;
    double largest = 0.0;
    for (const LinearRgb& colour : colour_grid()) {
        const RgbPaint made = rgb_paint(colour);
        const double difference = ciede2000(lab(masstone(made.coefficients)), lab(paint_colour(colour)));
        EXPECT_NEAR(made.difference, difference, 1e-9);
        exact += difference < 0.2 ? 1 : 0;
        largest = std::max(largest, difference);
    }
    // The design asks for 98 %; 99.6 % measured. What is left is nearly black, where no paint is as
    // dark.
    EXPECT_GE(exact, 0.98 * 729);
    EXPECT_LE(largest, 0.6);
}

TEST(RgbPaint, ThatMissesItsColourIsNearlyBlack) {
    for (const LinearRgb& colour : colour_grid()) {
        if (rgb_paint(colour).difference < 0.05) continue;
        EXPECT_LT(lab(colour).lightness, 10.0);
    }
}

TEST(RgbPaint, WhiteIsAsWhiteAsTitaniumWhite) {
    const Lab titanium = lab(masstone(find_pigment("PW6").coefficients));
    // Titanium white absorbs a trace of violet, the free white does not.
    EXPECT_LT(ciede2000(lab(masstone(paint("#ffffff").coefficients)), titanium), 0.6);
}

TEST(RgbPaint, MixesLikePaint) {
    // The design gives the mixtures of a yellow, a blue, a cyan and a red without saying which: these
    // are such paints, and their mixtures come within 6.4 steps of 255.
    expect_mixture("#dcb414", "#0078c8", {100, 133, 98}, 10);
    expect_mixture("#dcb414", "#28dcb4", {150, 187, 89}, 10);
    expect_mixture("#dcb414", "#ff5028", {229, 108, 44}, 10);
}

TEST(RgbPaint, YellowAndBlackMakeOlive) {
    const Lab olive = lab(mixed({{"#dcb414", 4.0}, {"#101010", 1.0}}));
    EXPECT_GT(olive.hue_deg(), 90.0);  // that of the yellow is 87
    EXPECT_LT(olive.hue_deg(), 125.0);
    EXPECT_GT(olive.chroma(), 10.0);
    EXPECT_LT(olive.lightness, 50.0);
}

TEST(RgbPaint, StaysWithinWhatPaintCanBe) {
    for (const LinearRgb& colour : colour_grid()) {
        const Coefficients made = rgb_paint(colour).coefficients;
        for (int band = 0; band < kBands; ++band) {
            EXPECT_GT(made[band], 0.0F);
            EXPECT_LE(made[band], 1.0001 * kStrongestAbsorption_per_mm);
            EXPECT_GT(made[kBands + band], 0.0F);
            EXPECT_LE(made[kBands + band], 60.0F);
        }
    }
}

TEST(RgbPaint, OpacityChangesHowItHidesAndNotItsColour) {
    const LinearRgb blue = decoded(*parse_hex_colour("#4060a0"));
    const Coefficients glaze = rgb_paint(blue, 0.1).coefficients;
    const Coefficients body = rgb_paint(blue, 2.0).coefficients;
    EXPECT_LT(ciede2000(lab(masstone(glaze)), lab(masstone(body))), 1e-3);
    EXPECT_LT(contrast_ratio(glaze), 0.5 * contrast_ratio(body));
}

TEST(PaintOfBands, UndoesTheSurface) {
    const Bands bands = {0.002F, 0.01F, 0.1F, 0.4F, 0.8F, 0.955F};
    const Bands again = opaque_bands(paint_of_bands(bands));
    for (int band = 0; band < kBands; ++band)
        EXPECT_NEAR(again[band], bands[band], 2e-6F);  // a few roundings of float
}

TEST(SmoothBands, OfAGreyIsTheSameInEveryBand) {
    const LinearRgb grey = {0.3F, 0.3F, 0.3F};
    const SmoothBands fit = smooth_bands(grey);
    EXPECT_TRUE(fit.converged);
    EXPECT_LE(fit.iterations, 12);
    for (const float reflectance : fit.reflectance)
        EXPECT_NEAR(reflectance, 0.3F, 1e-5F);
}

TEST(SmoothBands, TakesABoundedNumberOfStepsAndRarelyRunsOut) {
    int unfinished = 0, steps = 0;
    for (const LinearRgb& colour : colour_grid()) {
        const SmoothBands fit = smooth_bands(paint_colour(colour));
        EXPECT_LE(fit.iterations, kMostIterations);
        steps += fit.iterations;
        unfinished += fit.converged ? 0 : 1;
    }
    // 15.7 steps on average and 42 unfinished were measured.
    EXPECT_LE(steps, 20 * 729);
    EXPECT_LE(unfinished, 60);
}

TEST(SmoothBands, AnswersUnlikelyColoursToo) {
    for (const LinearRgb& colour : {LinearRgb{0, 0, 0}, LinearRgb{1, 1, 1}, LinearRgb{1, 0, 0},
                                    LinearRgb{2, 2, 2}, LinearRgb{0, 0, 1}}) {
        for (const float reflectance : smooth_bands(colour).reflectance) {
            EXPECT_GE(reflectance, kDarkestBand);
            EXPECT_LE(reflectance, kLightestBand);
        }
    }
}

}  // namespace
}  // namespace pastoso::pigment
