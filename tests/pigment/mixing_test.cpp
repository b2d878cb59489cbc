// How the palette's paints mix, as hue and chroma in CIE Lab: what a painter would notice first.
#include "pigment/appearance.hpp"
#include "pigment/lab.hpp"
#include "pigment/palette.hpp"

#include <cmath>
#include <initializer_list>
#include <utility>

#include <gtest/gtest.h>

namespace pastoso::pigment {
namespace {

/// The design's figures, from another program over the same data. They are rounded, and a painter names
/// the same colour within this.
constexpr double kHueTolerance_deg = 8.0;

Lab masstone(std::initializer_list<std::pair<const char*, double>> recipe) {
    std::vector<Portion> portions;
    for (const auto& [name, parts] : recipe)
        portions.push_back({find_pigment(name).coefficients, parts});
    return lab(pigment::masstone(mix(portions)));
}

void expect_hue(const Lab& colour, double hue_deg) {
    EXPECT_LE(std::abs(std::remainder(colour.hue_deg() - hue_deg, 360.0)), kHueTolerance_deg)
        << "hue " << colour.hue_deg() << " chroma " << colour.chroma();
}

TEST(Mixing, HansaYellowAndPhthaloBlueMakeABrightGreen) {
    const Lab green = masstone({{"PY74", 20}, {"PB15:3", 1}});
    expect_hue(green, 139.0);
    EXPECT_NEAR(green.chroma(), 70.0, 8.0);
}

TEST(Mixing, CadmiumYellowAndUltramarineMakeADullGreen) {
    const Lab green = masstone({{"PY35", 1}, {"PB29", 1}});
    expect_hue(green, 136.0);
    EXPECT_NEAR(green.chroma(), 30.0, 8.0);
}

TEST(Mixing, HansaYellowAndPyrroleRedMakeOrange) {
    const Lab orange = masstone({{"PY74", 3}, {"PR254", 1}});
    expect_hue(orange, 46.0);
    EXPECT_NEAR(orange.chroma(), 71.0, 8.0);
}

TEST(Mixing, CadmiumYellowAndBlackMakeOlive) {
    expect_hue(masstone({{"PY35", 4}, {"PBk9", 1}}), 102.0);
}

TEST(Mixing, UltramarineAndBurntUmberMakeANeutralGrey) {
    EXPECT_LE(masstone({{"PB29", 1}, {"PBr7-BU", 1}, {"PW6", 8}}).chroma(), 8.0);
}

TEST(Mixing, BluesTurnGreenerInATint) {
    expect_hue(masstone({{"PB15:3", 1}}), 304.0);
    expect_hue(masstone({{"PB15:3", 1}, {"PW6", 99}}), 236.0);
    expect_hue(masstone({{"PB29", 1}}), 310.0);
    expect_hue(masstone({{"PB29", 1}, {"PW6", 99}}), 269.0);
}

}  // namespace
}  // namespace pastoso::pigment
