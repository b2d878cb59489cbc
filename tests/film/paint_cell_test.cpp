#include "film/cell/paint_cell.hpp"

#include "film/medium.hpp"
#include "film/state.hpp"
#include "pigment/palette.hpp"

#include <cmath>
#include <limits>

#include <gtest/gtest.h>

namespace {

using namespace pastoso::film;  // NOLINT(google-build-using-namespace)

TEST(PaintCoefficients, HoldPigmentAndMedium) {
    const auto& pigment = pastoso::pigment::find_pigment("PB29").coefficients;
    Medium medium;
    medium.viscosity_m2_s = kThinnest_m2_s * std::exp(3.0);
    medium.yield_stress_Pa = 12.0;
    medium.solid_fraction = 0.25;
    medium.touch_dry_s = 1800.0;
    medium.typical_thickness_mm = 0.5;
    const PaintCoefficients paint = paint_coefficients(pigment, medium);
    for (int k = 0; k < kPigmentChannels; ++k)
        EXPECT_EQ(paint[k], pigment[k]);
    EXPECT_FLOAT_EQ(paint[kViscosityChannel], 3.0F);
    EXPECT_EQ(paint[kYieldChannel], 12.0F);
    EXPECT_EQ(paint[kSolidsChannel], 0.25F);
    EXPECT_EQ(paint[kDryingChannel], 1.0F);  // hours a millimetre
}

TEST(PaintCoefficients, AreNeverNegative) {
    Medium water;
    water.viscosity_m2_s = 1e-7;
    EXPECT_EQ(paint_coefficients({}, water)[kViscosityChannel], 0.0F);
}

TEST(PaintCoefficients, OfEveryMediumFitIntoACell) {
    for (const Medium& medium : bundled_media())
        for (const float per_mm : paint_coefficients({}, medium))
            EXPECT_LT(kMaxThickness_mm * per_mm / kPaintQuantum,
                      std::numeric_limits<std::int32_t>::max())
                << medium.name;
}

TEST(PaintCoefficients, OfTheStrongestPaintFitIntoACell) {
    EXPECT_LT(kMaxThickness_mm * pastoso::pigment::kMostPerMm / kPaintQuantum,
              std::numeric_limits<std::int32_t>::max());
}

}  // namespace
