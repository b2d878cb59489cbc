#include "pigment/working_space.hpp"

#include "pigment/colour.hpp"

#include <gtest/gtest.h>

namespace pastoso::pigment {
namespace {

constexpr WorkingSpace kSpaces[] = {WorkingSpace::Srgb, WorkingSpace::DisplayP3};

TEST(WorkingSpace, MatricesAreThoseOfTheStandards) {
    // CSS Color 4, section 18, from the same primaries and white.
    const Matrix3 srgb = {{{0.41239079926595934, 0.357584339383878, 0.1804807884018343},
                           {0.21263900587151027, 0.715168678767756, 0.07219231536073371},
                           {0.01933081871559182, 0.11919477979462598, 0.9505321522496607}}};
    const Matrix3 p3 = {{{0.4865709486482162, 0.26566769316909306, 0.1982172852343625},
                         {0.2289745640697488, 0.6917385218365064, 0.079286914093745},
                         {0.0, 0.04511338185890264, 1.043944368900976}}};
    for (int i = 0; i < 3; ++i) {
        for (int j = 0; j < 3; ++j) {
            EXPECT_NEAR(xyz_from_linear(WorkingSpace::Srgb)[i][j], srgb[i][j], 1e-12);
            EXPECT_NEAR(xyz_from_linear(WorkingSpace::DisplayP3)[i][j], p3[i][j], 1e-12);
        }
    }
}

TEST(WorkingSpace, WhiteIsTheSameInAll) {
    for (const WorkingSpace from : kSpaces) {
        const Vector3 white = transformed(xyz_from_linear(from), {1.0, 1.0, 1.0});
        for (int i = 0; i < 3; ++i)
            EXPECT_NEAR(white[i], white_xyz(kD65White)[i], 1e-14);
        for (const WorkingSpace to : kSpaces) {
            for (const double channel : transformed(linear_from_linear(to, from), {0.5, 0.5, 0.5}))
                EXPECT_NEAR(channel, 0.5, 1e-14);
        }
    }
}

TEST(WorkingSpace, TheWayBackIsTheInverse) {
    const Vector3 colour = {0.8, 0.1, 0.3};
    for (const WorkingSpace space : kSpaces) {
        const Vector3 back =
            transformed(linear_from_xyz(space), transformed(xyz_from_linear(space), colour));
        for (int i = 0; i < 3; ++i)
            EXPECT_NEAR(back[i], colour[i], 1e-14);
    }
}

TEST(WorkingSpace, LuminanceWeightsAreThePrimariesLuminances) {
    for (const WorkingSpace space : kSpaces) {
        float sum = 0.0F;
        for (int i = 0; i < 3; ++i) {
            EXPECT_NEAR(luminance_weights(space)[i], xyz_from_linear(space)[1][i], 5e-5);
            sum += luminance_weights(space)[i];
        }
        EXPECT_FLOAT_EQ(sum, 1.0F);
    }
}

TEST(WorkingSpace, AllOfSrgbFitsIntoDisplayP3) {
    const Matrix3 to_p3 = linear_from_linear(WorkingSpace::DisplayP3, WorkingSpace::Srgb);
    for (int corner = 0; corner < 8; ++corner) {
        const Vector3 colour = {corner & 1 ? 1.0 : 0.0, corner & 2 ? 1.0 : 0.0, corner & 4 ? 1.0 : 0.0};
        for (const double channel : transformed(to_p3, colour)) {
            EXPECT_GE(channel, -1e-12);
            EXPECT_LE(channel, 1.0 + 1e-12);
        }
    }
}

TEST(IntoGamut, MapsWithTheLuminanceOfTheSpace) {
    const LinearRgb outside = {1.1F, 0.4F, 0.2F};
    const float grey = 0.2290F * 1.1F + 0.6917F * 0.4F + 0.0793F * 0.2F;
    const float share = (1.0F - grey) / (1.1F - grey);
    const LinearRgb mapped = into_gamut(outside, WorkingSpace::DisplayP3);
    EXPECT_NEAR(mapped[1], 0.5F * (0.4F + grey + share * (0.4F - grey)), 1e-6F);
    EXPECT_NE(mapped, into_gamut(outside, WorkingSpace::Srgb));
}

}  // namespace
}  // namespace pastoso::pigment
