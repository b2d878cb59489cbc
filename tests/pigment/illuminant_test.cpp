#include "pigment/illuminant.hpp"

#include "document/error_of.hpp"
#include "pigment/observer.hpp"
#include "pigment/working_space.hpp"

#include <cmath>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace pastoso::pigment {
namespace {

using document::error_of;
using testing::HasSubstr;

std::string readings(int from_nm, int to_nm, int step_nm, double (*power)(int)) {
    std::string text;
    for (int nm = from_nm; nm <= to_nm; nm += step_nm)
        text += std::to_string(nm) + "," + std::to_string(power(nm)) + "\n";
    return text;
}

std::string even_readings(int from_nm = 380, int to_nm = 730, int step_nm = 10) {
    return readings(from_nm, to_nm, step_nm, [](int) { return 1.0; });
}

std::string failure(const std::string& csv) {
    return error_of([&] { parse_illuminant(csv, "lamp.csv"); });
}

Chromaticity chromaticity(const Illuminant& light) {
    const Vector3 white = white_under(light.power);
    const double sum = white[0] + white[1] + white[2];
    return {white[0] / sum, white[1] / sum};
}

TEST(BundledIlluminants, HaveTheirWhites) {
    // CIE 015:2018; sums over 10 nm instead of 1 nm are off by up to 6e-4.
    const std::pair<const char*, Chromaticity> whites[] = {{"D65", {0.31272, 0.32903}},
                                                           {"D50", {0.34567, 0.35851}},
                                                           {"A", {0.44758, 0.40745}},
                                                           {"LED", {0.3756, 0.3723}}};
    ASSERT_EQ(std::size(whites), kBundledIlluminants.size());
    for (const auto& [name, white] : whites) {
        EXPECT_NEAR(chromaticity(find_illuminant(name)).x, white.x, 1e-3) << name;
        EXPECT_NEAR(chromaticity(find_illuminant(name)).y, white.y, 1e-3) << name;
    }
}

TEST(BundledIlluminants, AIsABlackBody) {
    // CIE 015:2018: Planck's law with c2 / T = 1.435e7 / 2848 nm, 100 at 560 nm.
    const auto exponential = [](double nm) { return std::exp(1.435e7 / (2848.0 * nm)) - 1.0; };
    const Illuminant light = find_illuminant("A");
    for (int i = 0; i < kSpectralSamples; ++i) {
        const double nm = kFirstWavelength_nm + kWavelengthStep_nm * i;
        const double power = 100.0 * std::pow(560.0 / nm, 5) * exponential(560.0) / exponential(nm);
        EXPECT_NEAR(light.power[i], power, 1e-5 * power) << nm;
    }
}

TEST(BundledIlluminants, AreFoundInSmallLettersToo) {
    EXPECT_EQ(find_illuminant("d50").name, "D50");
    EXPECT_EQ(find_illuminant("led").power, find_illuminant("LED").power);
}

TEST(ParseIlluminant, TakesReadingsAtTheSamplesAsTheyAre) {
    const Illuminant light =
        parse_illuminant(readings(380, 730, 10, [](int nm) { return nm % 7 + 0.5; }), "lamp.csv");
    for (int i = 0; i < kSpectralSamples; ++i)
        EXPECT_EQ(light.power[i], (kFirstWavelength_nm + kWavelengthStep_nm * i) % 7 + 0.5);
}

TEST(ParseIlluminant, HeadingCommentsSpacesAndWindowsLineEndsAreNoReadings) {
    std::string csv = "# a lamp\r\nwavelength_nm,power\r\n\r\n";
    for (int nm = 380; nm <= 730; nm += 10)
        csv += " " + std::to_string(nm) + " ,\t2.5\r\n";
    for (const double power : parse_illuminant(csv, "lamp.csv").power)
        EXPECT_EQ(power, 2.5);
}

TEST(ParseIlluminant, LinesAreStraightBetweenCoarseReadings) {
    const Illuminant light =
        parse_illuminant(readings(350, 750, 25, [](int nm) { return nm - 300.0; }), "lamp.csv");
    for (int i = 0; i < kSpectralSamples; ++i)
        EXPECT_NEAR(light.power[i], kFirstWavelength_nm + kWavelengthStep_nm * i - 300.0, 1e-9);
}

TEST(ParseIlluminant, ALineBetweenTheSamplesKeepsItsPower) {
    // All power above the even 1 within 1 nm: its sum over the samples is that over the wavelengths.
    const auto with_line = [](int nm) { return nm == 546 ? 101.0 : 1.0; };
    const Illuminant light = parse_illuminant(readings(380, 730, 1, with_line), "lamp.csv");
    double sum = 0.0;
    for (const double power : light.power)
        sum += kWavelengthStep_nm * (power - 1.0);
    EXPECT_NEAR(sum, 100.0, 1e-9);
    EXPECT_NEAR(light.power[17] - 1.0, 6.0, 1e-9);
}

TEST(ParseIlluminant, TheEndsHoldBeyondTheReadings) {
    const Illuminant light = parse_illuminant(even_readings(400, 700), "lamp.csv");
    EXPECT_EQ(light.power.front(), 1.0);
    EXPECT_EQ(light.power.back(), 1.0);
}

TEST(ParseIlluminant, NamesFileLineAndValue) {
    EXPECT_EQ(failure("wavelength_nm,power\n380,1\n390,abc\n"),
              "lamp.csv, line 3: the power \"abc\" is not a finite number.");
    EXPECT_EQ(failure("38x,1\n"), "lamp.csv, line 1: the wavelength \"38x\" is not a finite number.");
    EXPECT_EQ(failure("380,inf\n"), "lamp.csv, line 1: the power \"inf\" is not a finite number.");
    EXPECT_EQ(failure("380,1\n390,-2\n"), "lamp.csv, line 2: the power -2 is negative.");
    EXPECT_EQ(failure("380,1\n380,2\n"),
              "lamp.csv, line 2: the wavelength 380 nm is not greater than that of the line before.");
    EXPECT_EQ(failure("380;1\n"),
              "lamp.csv, line 1: \"380;1\" is not a wavelength in nm and a power with one comma.");
    EXPECT_EQ(failure("380,1,2\n"),
              "lamp.csv, line 1: \"380,1,2\" is not a wavelength in nm and a power with one comma.");
}

TEST(ParseIlluminant, RefusesWhatIsNoLightToSeeBy) {
    EXPECT_EQ(failure("# nothing\n"), "lamp.csv: there is no reading of a light in this file.");
    EXPECT_EQ(failure(even_readings(420, 730)),
              "lamp.csv: the readings go from 420 to 730 nm; a light is needed from 400 to 700 nm.");
    EXPECT_EQ(failure(readings(380, 730, 10, [](int) { return 0.0; })),
              "lamp.csv: this light has no power that is seen.");
    // A low-pressure sodium lamp.
    EXPECT_THAT(failure(readings(380, 730, 5, [](int nm) { return nm == 590 ? 1.0 : 0.0; })),
                HasSubstr("lamp.csv: this light is so nearly a pure colour that nothing looks white"));
}

TEST(FindIlluminant, NamesTheLightsThereAre) {
    EXPECT_EQ(
        error_of([] { find_illuminant("D56"); }),
        "There is no light \"D56\"; there are D65, D50, A and LED, or give the path of a CSV file.");
    EXPECT_THAT(error_of([] { find_illuminant("/nonexistent/lamp.csv"); }),
                HasSubstr("/nonexistent/lamp.csv"));
}

}  // namespace
}  // namespace pastoso::pigment
