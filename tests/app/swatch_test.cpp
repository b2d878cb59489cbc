#include "tools/swatch.hpp"

#include "pigment/palette.hpp"

#include <gtest/gtest.h>

namespace pastoso::tools {
namespace {

int brightness(const pigment::Srgb8& colour) {
    return colour[0] + colour[1] + colour[2];
}

TEST(Swatch, WhiteIsWhite) {
    const Swatch white = swatch(pigment::find_pigment("PW6").coefficients);
    for (const std::uint8_t channel : white.masstone)
        EXPECT_GE(channel, 240);
    EXPECT_EQ(white.tint, white.masstone);
}

TEST(Swatch, UltramarineIsBlueAndItsTintIsLighter) {
    const Swatch blue = swatch(pigment::find_pigment("PB29").coefficients);
    EXPECT_GT(blue.masstone[2], blue.masstone[0]);
    EXPECT_GT(blue.masstone[2], blue.masstone[1]);
    EXPECT_GT(blue.tint[2], blue.tint[0]);
}

TEST(Swatch, EveryTintIsAtLeastAsLightAsItsMasstone) {
    for (const pigment::Pigment& pigment : pigment::bundled_palette()) {
        const Swatch colours = swatch(pigment.coefficients);
        // Zinc white is whiter than titanium white by less than the rounding to eight bits.
        EXPECT_GE(brightness(colours.tint) + 3, brightness(colours.masstone)) << pigment.ci_name;
    }
}

}  // namespace
}  // namespace pastoso::tools
