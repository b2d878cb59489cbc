#include "pigment/viewing.hpp"

#include "core/resources.hpp"
#include "core/text_file.hpp"
#include "pigment/adaptation.hpp"
#include "pigment/band_fit.hpp"
#include "pigment/colour_metric.hpp"
#include "pigment/lab.hpp"
#include "pigment/observer.hpp"

#include <cmath>
#include <random>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace pastoso::pigment {
namespace {

TEST(Bradford, TakesOneWhiteToTheOtherAndBack) {
    const Vector3 lamp = white_under(find_illuminant("A").power), day = white_xyz(kD65White);
    const Vector3 seen = transformed(bradford(lamp, day), lamp);
    const Vector3 colour = {0.3, 0.2, 0.6};
    const Vector3 back = transformed(bradford(day, lamp), transformed(bradford(lamp, day), colour));
    for (int i = 0; i < 3; ++i) {
        EXPECT_NEAR(seen[i], day[i], 1e-14);
        EXPECT_NEAR(back[i], colour[i], 1e-14);
    }
}

TEST(Bradford, IsThatOfTheProfileStandard) {
    // ICC.1:2022, E.3: D65 to the D50 of the connection space, four digits.
    const double expected[3][3] = {
        {1.0478, 0.0229, -0.0501}, {0.0295, 0.9905, -0.0171}, {-0.0092, 0.0150, 0.7517}};
    const Matrix3 matrix = bradford(white_xyz(kD65White), {0.9642, 1.0, 0.8249});
    for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j)
            EXPECT_NEAR(matrix[i][j], expected[i][j], 2e-4);
}

TEST(ColourMetric, IsTheDifferenceOfNearColours) {
    std::mt19937 random(5);
    std::uniform_real_distribution<double> channel(0.15, 0.85), step(-1e-4, 1e-4);
    const Vector3 white = white_xyz(kD65White);
    for (int i = 0; i < 1000; ++i) {
        const double grey = channel(random);
        Vector3 colour{}, near{}, apart{};
        for (int k = 0; k < 3; ++k) {
            colour[k] = white[k] * (grey + 20.0 * step(random));
            apart[k] = step(random);
            near[k] = colour[k] + apart[k];
        }
        const Matrix3 metric = colour_metric(colour, white);
        const Vector3 weighted = transformed(metric, apart);
        const double size =
            std::sqrt(apart[0] * weighted[0] + apart[1] * weighted[1] + apart[2] * weighted[2]);
        // Near greys what is left out of the formula is small.
        EXPECT_NEAR(size, ciede2000(lab(colour, white), lab(near, white)), 0.05 * size);
    }
}

TEST(Viewing, DaylightIsTheUsual) {
    EXPECT_EQ(viewing_under(find_illuminant("D65")), Viewing{});
}

TEST(Viewing, WhiteAndGreysStayNeutralInEveryLight) {
    for (const char* name : kBundledIlluminants) {
        for (const WorkingSpace space : {WorkingSpace::Srgb, WorkingSpace::DisplayP3}) {
            const Viewing viewing = viewing_under(find_illuminant(name), space);
            EXPECT_EQ(viewing.space, space);
            for (const float level : {0.0F, 0.18F, 1.0F}) {
                Bands bands{};
                bands.fill(level);
                for (const float seen : seen_colour(bands, viewing.to_rgb))
                    EXPECT_NEAR(seen, level, 1e-6F) << name;
            }
        }
    }
}

TEST(Viewing, DisplayP3HoldsTheSameColoursInOtherNumbers) {
    const Bands bands = {0.1F, 0.3F, 0.2F, 0.5F, 0.9F, 0.4F};
    const LinearRgb in_srgb = linear_srgb(bands);
    const LinearRgb in_p3 =
        seen_colour(bands, viewing_under(find_illuminant("D65"), WorkingSpace::DisplayP3).to_rgb);
    const Vector3 expected = transformed(linear_from_linear(WorkingSpace::DisplayP3, WorkingSpace::Srgb),
                                         {in_srgb[0], in_srgb[1], in_srgb[2]});
    for (int i = 0; i < 3; ++i)
        EXPECT_NEAR(in_p3[i], expected[i], 1e-6);
}

TEST(BandFit, FindsTheMatricesOfTheBandFileAgain) {
    const auto json =
        nlohmann::json::parse(core::read_text_file(core::resource_path("pigments/bands_6.json")));
    const std::pair<const char*, const char*> cases[] = {{"D65", "band_to_linear_sRGB_D65"},
                                                         {"A", "band_to_linear_sRGB_A_bradford"}};
    for (const auto& [name, entry] : cases) {
        const BandsToXyz fitted = fitted_bands_to_xyz(find_illuminant(name).power);
        for (int band = 0; band < kBands; ++band) {
            const Vector3 rgb = transformed(linear_from_xyz(WorkingSpace::Srgb),
                                            {fitted[0][band], fitted[1][band], fitted[2][band]});
            // D65's come from the fit, rounded; those for A were fitted to other mixtures and to both
            // lights at once.
            const double allowed = name == std::string("D65") ? 1e-7 : 0.02;
            for (int i = 0; i < 3; ++i)
                EXPECT_NEAR(rgb[i], json.at(entry).at(i).at(band).get<double>(), allowed) << name;
        }
    }
}

TEST(BandFit, ScaleOfThePowerDoesNotMatter) {
    Spectrum power = find_illuminant("LED").power;
    const BandsToXyz once = fitted_bands_to_xyz(power);
    for (double& sample : power)
        sample *= 1024.0;
    EXPECT_EQ(fitted_bands_to_xyz(power), once);
}

}  // namespace
}  // namespace pastoso::pigment
