#include "pigment/palette.hpp"

#include "core/error.hpp"
#include "core/text_file.hpp"
#include "source_file.hpp"

#include <sstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace pastoso::pigment {
namespace {

using testing::AllOf;
using testing::HasSubstr;

/// Windows that pick one sample each: band b sees sample 5 b.
BandWeights picking_weights() {
    BandWeights weights{};
    for (int band = 0; band < kBands; ++band)
        weights[band][5 * band] = 1.0;
    return weights;
}

std::string heading() {
    std::string text = "ci_name,name,coef";
    for (int nm = 380; nm <= 730; nm += 10)
        text += "," + std::to_string(nm);
    return text + "\n";
}

std::string row(const std::string& labels, double first) {
    std::ostringstream text;
    text << labels;
    for (int i = 0; i < kSpectralSamples; ++i)
        text << ',' << first + i;
    return text.str() + "\n";
}

std::string parse_failure(const std::string& csv) {
    try {
        parse_palette(csv, picking_weights(), "test.csv");
    } catch (const core::InputError& error) {
        return error.what();
    }
    return "no error";
}

TEST(ParsePalette, ReadsBothCoefficientsAndReducesThem) {
    const std::string csv =
        "# a comment\n" + heading() + row("X1,Test paint,K", 1.0) + row("X1,Test paint,S", 100.0);
    const std::vector<Pigment> palette = parse_palette(csv, picking_weights(), "test.csv");
    ASSERT_EQ(palette.size(), 1U);
    EXPECT_EQ(palette[0].ci_name, "X1");
    EXPECT_EQ(palette[0].name, "Test paint");
    EXPECT_EQ(palette[0].scattering_per_mm[35], 135.0);
    EXPECT_EQ(palette[0].coefficients,
              (Coefficients{1, 6, 11, 16, 21, 26, 100, 105, 110, 115, 120, 125}));
}

TEST(ParsePalette, AcceptsWindowsLineEnds) {
    std::string csv = heading() + row("X1,A,K", 1.0) + row("X1,A,S", 2.0);
    for (std::size_t at = 0; (at = csv.find('\n', at)) != std::string::npos; at += 2)
        csv.insert(at, "\r");
    EXPECT_EQ(parse_palette(csv, picking_weights(), "test.csv").size(), 1U);
}

TEST(ParsePalette, NamesTheFileLineColumnAndValue) {
    const std::string good = heading() + row("X1,A,K", 1.0);
    std::string text = good + row("X1,A,S", 2.0);
    text.replace(text.rfind(",37"), 3, ",abc");
    EXPECT_THAT(parse_failure(text), AllOf(HasSubstr("test.csv, line 3"), HasSubstr("column 39 (730)"),
                                           HasSubstr("\"abc\" is not a number")));
    EXPECT_THAT(parse_failure(good + row("X1,A,S", -1.5)),
                AllOf(HasSubstr("line 3: column 4 (380)"), HasSubstr("-1.5 per mm is negative")));
    EXPECT_THAT(parse_failure(good + "X1,A,S,nan" + row("", 2.0).substr(2)),
                AllOf(HasSubstr("column 4"), HasSubstr("not a finite number")));
    EXPECT_THAT(parse_failure(good + "X1,A,S,1,2,3\n"),
                HasSubstr("line 3: column 7 (410): missing; there are 6 columns instead of 39"));
    EXPECT_THAT(parse_failure(good + row("X1,A,T", 2.0)), HasSubstr("\"T\" is neither K nor S"));
    EXPECT_THAT(parse_failure(good + row("X1,A,K", 2.0)),
                HasSubstr("line 3: K of the pigment \"X1\" is given twice"));
    EXPECT_THAT(parse_failure(good), HasSubstr("the pigment \"X1\" has no line for S"));
    EXPECT_THAT(parse_failure(row("X1,A,K", 1.0)),
                HasSubstr("the heading is \"X1\" instead of \"ci_name\""));
    EXPECT_THAT(parse_failure(""), HasSubstr("there is no pigment"));
}

TEST(ParseBandWeights, RejectsWhatIsNoWindow) {
    const auto failure = [](const std::string& json) -> std::string {
        try {
            parse_band_weights(json, "b.json");
        } catch (const core::InputError& error) {
            return error.what();
        }
        return "no error";
    };
    EXPECT_THAT(failure("{"), HasSubstr("b.json: this is not valid JSON"));
    EXPECT_THAT(failure("{}"), HasSubstr("\"weights_380_730_10nm\" is missing"));
    EXPECT_THAT(failure(R"({"weights_380_730_10nm": [[1]]})"), HasSubstr("not a list of 6 bands"));
    EXPECT_THAT(failure(R"({"weights_380_730_10nm": [[1],[],[],[],[],[]]})"),
                HasSubstr("band 1 of \"weights_380_730_10nm\" is not a list of 36 numbers"));
    const std::string zeros = "0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0";
    const std::string rest = ",[],[],[],[],[]]}";
    EXPECT_THAT(failure(R"({"weights_380_730_10nm": [[-1,)" + zeros + "]" + rest),
                HasSubstr("380 nm: the weight -1 is negative"));
    EXPECT_THAT(failure(R"({"weights_380_730_10nm": [["x",)" + zeros + "]" + rest),
                HasSubstr("380 nm: \"x\" is not a number"));
    EXPECT_THAT(failure(R"({"weights_380_730_10nm": [[0.5,)" + zeros + "]" + rest),
                HasSubstr("instead of 1"));
}

TEST(BundledPalette, HoldsThePaintsOfTheBox) {
    EXPECT_EQ(bundled_palette().size(), 29U);
    EXPECT_EQ(find_pigment("PB29").name, "Ultramarine blue");
    EXPECT_EQ(find_pigment("PB15:3").name, "Phthalo blue GS");
}

TEST(BundledPalette, NamesTheNearestOfAnUnknownPaint) {
    const auto failure = [](const char* name) -> std::string {
        try {
            find_pigment(name);
        } catch (const core::InputError& error) {
            return error.what();
        }
        return "no error";
    };
    EXPECT_THAT(failure("PB92"),
                AllOf(HasSubstr("There is no pigment \"PB92\""), HasSubstr("PW6, PW4")));
    EXPECT_THAT(failure("pb29"), HasSubstr("did you mean PB29 (Ultramarine blue)"));
    EXPECT_THAT(failure("ultramarine"), HasSubstr("did you mean PB29 (Ultramarine blue)"));
}

TEST(BundledPalette, EqualsTheReferenceReduction) {
    std::istringstream file(
        core::read_text_file(tests::source_file("tests/data/pigment/pigments_6band.csv")));
    std::string text, cell;
    std::getline(file, text);
    std::size_t compared = 0;
    while (std::getline(file, text)) {
        std::istringstream fields(text);
        std::getline(fields, cell, ',');
        const Pigment& pigment = find_pigment(cell);
        std::getline(fields, cell, ',');
        for (const float value : pigment.coefficients) {
            std::getline(fields, cell, ',');
            const double expected = std::stod(cell);
            // Both files hold five digits.
            EXPECT_NEAR(value, expected, 2e-4 * expected) << text;
        }
        ++compared;
    }
    EXPECT_EQ(compared, bundled_palette().size());
}

TEST(Mix, IsTheMeanByVolume) {
    Coefficients a{}, b{};
    a.fill(1.0F);
    b.fill(5.0F);
    const Portion portions[] = {{a, 3.0}, {b, 1.0}};
    for (const float value : mix(portions))
        EXPECT_EQ(value, 2.0F);
    const Portion thinned[] = {{b, 1.0}, {Coefficients{}, 4.0}};
    for (const float value : mix(thinned))
        EXPECT_EQ(value, 1.0F);
}

}  // namespace
}  // namespace pastoso::pigment
