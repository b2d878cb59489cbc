#include "pigment/appearance.hpp"

#include "pigment/hex_colour.hpp"
#include "pigment/kubelka_munk.hpp"
#include "pigment/lab.hpp"
#include "pigment/palette.hpp"

#include <gtest/gtest.h>

namespace pastoso::pigment {
namespace {

const Coefficients& paint(const char* name) {
    return find_pigment(name).coefficients;
}

TEST(Appearance, ThickAndThinFilmsAreTheLimitsOfTheUndertone) {
    const LinearRgb white = masstone(paint("PW6"));
    for (int i = 0; i < 3; ++i) {
        EXPECT_NEAR(undertone(paint("PB29"), 0.0)[i], white[i], 1e-5);
        EXPECT_NEAR(undertone(paint("PR101"), 10.0)[i], masstone(paint("PR101"))[i], 1e-5);
    }
}

TEST(Appearance, TheUndertoneOfAThinFilmIsTheLayersReflectance) {
    Coefficients grey{};
    grey.fill(20.0F);
    const double ground = opaque_reflectance(paint("PW6")[3], paint("PW6")[9]);
    const double expected = through_surface(layer_reflectance(0.5, 0.5, ground));
    // In the first band titanium white absorbs a little, which shows in blue.
    EXPECT_NEAR(undertone(grey)[0], expected, 2e-3);
    EXPECT_NEAR(undertone(grey)[1], expected, 2e-3);
}

TEST(Appearance, ATintWithoutWhiteIsTheMasstone) {
    EXPECT_EQ(tint(paint("PB29"), 0.0), masstone(paint("PB29")));
    EXPECT_GT(tint(paint("PB29"))[2], 5.0F * masstone(paint("PB29"))[2]);
}

TEST(Appearance, OpacityRunsFromClearToHiding) {
    EXPECT_EQ(contrast_ratio(Coefficients{}), 0.0);
    EXPECT_GT(contrast_ratio(paint("PW6")), 0.85);
    EXPECT_GT(contrast_ratio(paint("PBk9")), 0.1);
    // Painters know zinc white as the transparent one.
    EXPECT_LT(contrast_ratio(paint("PW4")), contrast_ratio(paint("PW6")));
    EXPECT_NEAR(contrast_ratio(paint("PW6"), 10.0), 1.0, 1e-3);
}

TEST(Appearance, TintingStrengthIsThePartsOfWhiteOfAPaleTint) {
    EXPECT_EQ(tinting_strength(paint("PW6")), 0.0);
    EXPECT_EQ(tinting_strength(paint("PW4")), 0.0);
    const double blue = tinting_strength(paint("PB29"));
    EXPECT_NEAR(ciede2000(lab(tint(paint("PB29"), blue)), lab(masstone(paint("PW6")))), kPaleDifference,
                1e-3);
    // Every painter learns this from the first tube of phthalo.
    EXPECT_GT(tinting_strength(paint("PB15:3")), 4.0 * blue);
    EXPECT_LT(tinting_strength(paint("PG18")), tinting_strength(paint("PG7")));
}

TEST(Appearance, ScreensAndPaintsAreInProportion) {
    const LinearRgb colour = {0.2F, 0.4F, 0.955F};
    const LinearRgb again = paint_colour(screen_colour(colour));
    for (int i = 0; i < 3; ++i)
        EXPECT_NEAR(again[i], colour[i], 1e-6F);
    // Titanium white absorbs a trace of violet.
    for (const int channel : encoded(screen_colour(masstone(paint("PW6")))))
        EXPECT_GE(channel, 254);
}

TEST(HexColour, IsReadAndWritten) {
    EXPECT_EQ(parse_hex_colour("#c03020"), (Srgb8{192, 48, 32}));
    EXPECT_EQ(parse_hex_colour("#C0fFeE"), (Srgb8{192, 255, 238}));
    EXPECT_EQ(hex_colour({192, 255, 9}), "#c0ff09");
    for (const char* wrong : {"", "#", "c03020", "#c0302", "#c030200", "#c0302g", "# c0302", "#-10000",
                              "#+10000", "#0x1000"}) {
        EXPECT_EQ(parse_hex_colour(wrong), std::nullopt) << wrong;
    }
}

TEST(HexColour, EncodesWhatItDecodes) {
    for (int level = 0; level < 256; ++level) {
        const auto channel = static_cast<std::uint8_t>(level);
        const Srgb8 colour = {channel, static_cast<std::uint8_t>(255 - level), 7};
        EXPECT_EQ(encoded(decoded(colour)), colour);
    }
}

}  // namespace
}  // namespace pastoso::pigment
