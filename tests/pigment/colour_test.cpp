#include "pigment/colour.hpp"

#include "core/resources.hpp"
#include "core/text_file.hpp"
#include "pigment/lab.hpp"

#include <cmath>
#include <cmath>
#include <random>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace pastoso::pigment {
namespace {

TEST(LinearSrgb, MatrixIsThatOfTheBandFile) {
    const auto json =
        nlohmann::json::parse(core::read_text_file(core::resource_path("pigments/bands_6.json")));
    const auto& rows = json.at("band_to_linear_sRGB_D65");
    for (int i = 0; i < 3; ++i) {
        for (int band = 0; band < kBands; ++band) {
            EXPECT_FLOAT_EQ(kBandsToLinearSrgb[i][band], rows.at(i).at(band).get<float>());
        }
    }
}

TEST(LinearSrgb, EqualReflectancesAreGrey) {
    for (const float level : {0.0F, 0.18F, 1.0F}) {
        Bands bands{};
        bands.fill(level);
        for (const float channel : linear_srgb(bands))
            EXPECT_NEAR(channel, level, 1e-6F);
    }
}

TEST(TransferCurve, HitsKnownValuesAndReturns) {
    EXPECT_EQ(encode_srgb(0.0), 0.0);
    EXPECT_NEAR(encode_srgb(1.0), 1.0, 1e-15);
    EXPECT_NEAR(encode_srgb(0.2140411405), 0.5, 1e-9);
    for (double v = 0.0; v <= 1.0; v += 1.0 / 64)
        EXPECT_NEAR(decode_srgb(encode_srgb(v)), v, 1e-7);
}

TEST(IntoGamut, KeepsWhatFitsAndNeutralsNeutral) {
    EXPECT_EQ(into_gamut({0.1F, 0.0F, 1.0F}), (LinearRgb{0.1F, 0.0F, 1.0F}));
    EXPECT_EQ(into_gamut({2.0F, 2.0F, 2.0F}), (LinearRgb{1.0F, 1.0F, 1.0F}));
    EXPECT_EQ(into_gamut({-1.0F, -1.0F, -1.0F}), (LinearRgb{0.0F, 0.0F, 0.0F}));
}

TEST(IntoGamut, IsTheMeanOfClippingAndDesaturating) {
    const LinearRgb mapped = into_gamut({1.2F, 0.5F, -0.1F});
    const float grey = 0.2126F * 1.2F + 0.7152F * 0.5F - 0.0722F * 0.1F;
    const float share = std::min((1.0F - grey) / (1.2F - grey), grey / (grey + 0.1F));
    EXPECT_NEAR(mapped[0], 0.5F * (1.0F + grey + share * (1.2F - grey)), 1e-6F);
    EXPECT_NEAR(mapped[1], 0.5F * (0.5F + grey + share * (0.5F - grey)), 1e-6F);
    EXPECT_NEAR(mapped[2], 0.5F * (0.0F + grey + share * (-0.1F - grey)), 1e-6F);
}

/// Also what lies outside by less than the share of grey that would bring it in can tell.
TEST(IntoGamut, LeavesNothingOutsideByARounding) {
    for (const float outside :
         {-1e-38F, -1e-17F, -1e-9F, -1e-8F, -1e-7F, std::nextafter(1.0F, 2.0F), 1.0000005F})
        for (int channel = 0; channel < 3; ++channel) {
            LinearRgb colour{0.3F, 0.9F, 0.5F};
            colour[channel] = outside;
            const LinearRgb mapped = into_gamut(colour);
            for (int i = 0; i < 3; ++i) {
                EXPECT_GE(mapped[i], 0.0F) << outside;
                EXPECT_LE(mapped[i], 1.0F) << outside;
                EXPECT_NEAR(mapped[i], colour[i], 1e-6F) << outside;
            }
        }
}

TEST(IntoGamut, AlwaysFits) {
    std::mt19937 random(3);
    std::uniform_real_distribution<float> channel(-1.0F, 3.0F);
    for (int i = 0; i < 10000; ++i) {
        for (const float mapped : into_gamut({channel(random), channel(random), channel(random)})) {
            EXPECT_GE(mapped, 0.0F);
            EXPECT_LE(mapped, 1.0F);
        }
    }
}

TEST(Ciede2000, GivesThePublishedDifferences) {
    // Sharma, Wu, Dalal 2005, table 1, pairs 1, 7, 17 and 25.
    EXPECT_NEAR(ciede2000({50, 2.6772, -79.7751}, {50, 0, -82.7485}), 2.0425, 5e-5);
    EXPECT_NEAR(ciede2000({50, 0, 0}, {50, -1, 2}), 2.3669, 5e-5);
    EXPECT_NEAR(ciede2000({50, 2.5, 0}, {73, 25, -18}), 27.1492, 5e-5);
    EXPECT_NEAR(ciede2000({60.2574, -34.0099, 36.2677}, {60.4626, -34.1751, 39.4387}), 1.2644, 5e-5);
}

}  // namespace
}  // namespace pastoso::pigment
