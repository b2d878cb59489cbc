#include "film/cell/cell_drying.hpp"

#include "core/units.hpp"
#include "film/dry_film.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include <gtest/gtest.h>

namespace pastoso::film::test {
namespace {

/// A cell of fresh paint.
struct Cell {
    Cell(const char* medium_name, double thickness_mm)
        : medium(find_medium(medium_name)),
          thickness(quanta_of(thickness_mm)),
          paint(cell_of(paint_coefficients(kBlue, medium), thickness_mm)) {}

    double viscosity_m2_s() const { return kThinnest_m2_s * std::exp(per_mm(kViscosityChannel)); }
    double yield_Pa() const { return per_mm(kYieldChannel); }
    double per_mm(int channel) const {
        return paint[channel] * kPaintQuantum / (thickness * kThicknessQuantum_mm);
    }

    const Medium& medium;
    std::int32_t thickness;
    PaintCell paint;
};

/// The carried channels round to 2^-18 mm, 4e-6 of the thickness in these tests; the exponential turns
/// that into as much of the viscosity, and the mean over a thousand steps stays as small.
constexpr double kRounding = 1e-4;

TEST(DryOn, FollowsTheLawsAtHalfTime) {
    Cell cell("soft-body acrylic", 1.0);
    const PaintCell before = cell.paint;
    const std::int32_t half = cell.paint[kDryingChannel] / 2;
    const std::int32_t evaporated = dry_on(half, cell.thickness, cell.paint);
    EXPECT_EQ(cell.thickness, quanta_of(1.0) - evaporated);
    EXPECT_NEAR(evaporated * kThicknessQuantum_mm, 0.5 * (1.0 - 0.65), 1e-5);
    EXPECT_EQ(cell.paint[kDryingChannel], before[kDryingChannel] - half);
    EXPECT_EQ(cell.paint[kSolidsChannel], before[kSolidsChannel]);
    EXPECT_TRUE(std::equal(before.begin(), before.begin() + kPigmentChannels, cell.paint.begin()));
    EXPECT_NEAR(cell.viscosity_m2_s() / (4.0 * 0.03), 1.0, kRounding);
    EXPECT_NEAR(cell.yield_Pa(), 15.0 + 250.0 * 3.0 * 0.03, 100 * kRounding);
}

TEST(DryOn, ManySmallStepsAreAsGoodAsOneLargeOne) {
    Cell once("house paint", 0.4), often("house paint", 0.4);
    const std::int32_t step = once.paint[kDryingChannel] / 1000;
    dry_on(900 * step, once.thickness, once.paint);
    for (int i = 0; i < 900; ++i)
        dry_on(step, often.thickness, often.paint);
    EXPECT_EQ(often.paint[kDryingChannel], once.paint[kDryingChannel]);
    EXPECT_NEAR(often.thickness, once.thickness, 1000);  // a quantum a step
    // Each of 900 roundings is random; together they stay within 30 of 2^-18 mm.
    EXPECT_NEAR(often.viscosity_m2_s() / once.viscosity_m2_s(), 1.0, 1e-3);
    EXPECT_NEAR(often.yield_Pa() / once.yield_Pa(), 1.0, 1e-3);
}

TEST(DryOn, PaintNearlyDryStandsStill) {
    Cell cell("ink glaze", 0.2);
    dry_on(cell.paint[kDryingChannel] / 100 * 99, cell.thickness, cell.paint);
    const double standing_mm =
        cell.yield_Pa() / (cell.medium.density_kg_m3 * core::kStandardGravity_mm_s2 * 1e-6);
    EXPECT_GT(standing_mm, cell.thickness * kThicknessQuantum_mm);
}

TEST(DryOn, TheLastQuantumWaitsUntilTheCellIsDry) {
    std::int32_t thickness = 1;
    PaintCell paint{};
    paint[kDryingChannel] = 1000;
    EXPECT_EQ(dry_on(999, thickness, paint), 0);
    EXPECT_EQ(thickness, 1);
    EXPECT_EQ(paint[kDryingChannel], 1);
}

TEST(DryOn, StiffensWithinBounds) {
    Cell cell("heavy-body oil", 3.0);
    while (cell.paint[kDryingChannel] > 1)
        dry_on(std::max(1, cell.paint[kDryingChannel] / 2), cell.thickness, cell.paint);
    EXPECT_NEAR(cell.viscosity_m2_s() / 1e4, 1.0, kRounding);
    EXPECT_NEAR(cell.yield_Pa(), 1000.0, 1e-2);
}

struct Below {
    float support_mm = 0.25F;
    std::int32_t soluble_thickness = 0;
    PigmentCell soluble_pigment{};
    StrataOptics optics = kClearStrata;
    PigmentMixture uppermost{};
    DriedTotals fixed;
    StrataCell cell() {
        return {support_mm, soluble_thickness, soluble_pigment, optics, uppermost, fixed};
    }
};

TEST(BecomeStratum, SolidsBecomeSupportAndPigmentAStratum) {
    Cell acrylic("soft-body acrylic", 1.0);
    const PaintCell before = acrylic.paint;
    Below below;
    const std::int32_t evaporated = become_stratum(acrylic.thickness, acrylic.paint, below.cell());
    EXPECT_EQ(acrylic.thickness, 0);
    EXPECT_EQ(acrylic.paint, PaintCell{});
    EXPECT_EQ(below.fixed.thickness + evaporated, quanta_of(1.0));
    EXPECT_EQ(below.fixed.thickness % kQuantaPerSupport, 0);
    EXPECT_NEAR(thickness_mm(static_cast<std::int32_t>(below.fixed.thickness)), 0.65, 1e-5);
    EXPECT_EQ(below.support_mm, 0.25F + thickness_mm(static_cast<std::int32_t>(below.fixed.thickness)));
    for (int k = 0; k < kPigmentChannels; ++k)
        EXPECT_EQ(below.fixed.pigment[k], before[k]);
    EXPECT_EQ(below.soluble_thickness, 0);
    expect_seen(below.optics, wet_over(before.data(), kWhiteGround));
}

TEST(BecomeStratum, PaintWithHardlyAnyBinderCanBeDissolved) {
    Cell ink("ink glaze", 0.08);
    const PaintCell before = ink.paint;
    Below below;
    become_stratum(ink.thickness, ink.paint, below.cell());
    EXPECT_EQ(below.fixed, DriedTotals{});
    EXPECT_EQ(below.optics, kClearStrata);
    EXPECT_TRUE(std::equal(below.soluble_pigment.begin(), below.soluble_pigment.end(), before.begin()));
    EXPECT_NEAR(thickness_mm(below.soluble_thickness), 0.0016, 1e-5);
}

TEST(BecomeStratum, DryLayersLieOverEachOtherAndDoNotMix) {
    Below below;
    Cell ink("ink glaze", 0.08), oil("heavy-body oil", 0.1);
    const PaintCell ink_paint = ink.paint, oil_paint = oil.paint;
    become_stratum(ink.thickness, ink.paint, below.cell());
    become_stratum(oil.thickness, oil.paint, below.cell());
    expect_seen(below.optics, wet_over(oil_paint.data(), wet_over(ink_paint.data(), kWhiteGround)));
    EXPECT_EQ(below.soluble_thickness, 0);
    EXPECT_EQ(below.soluble_pigment, PigmentCell{});
    for (int k = 0; k < kPigmentChannels; ++k)
        EXPECT_EQ(below.fixed.pigment[k], std::int64_t{ink_paint[k]} + oil_paint[k]);
}

TEST(BecomeStratum, SealsBeforeTheIntegersOverflow) {
    Below below;
    below.soluble_pigment.fill(std::numeric_limits<std::int32_t>::max());
    Cell ink("ink glaze", 0.08);
    become_stratum(ink.thickness, ink.paint, below.cell());
    EXPECT_EQ(below.fixed.pigment[3], std::numeric_limits<std::int32_t>::max());
    EXPECT_GT(below.soluble_pigment[3], 0);
}

TEST(BecomeStratum, PureThinnerLeavesNothing) {
    Below below;
    std::int32_t thickness = quanta_of(0.1);
    PaintCell paint = cell_of(paint_coefficients({}, find_medium("thinner")), 0.1);
    EXPECT_EQ(become_stratum(thickness, paint, below.cell()), quanta_of(0.1));
    EXPECT_EQ(below.support_mm, 0.25F);
    EXPECT_EQ(below.fixed, DriedTotals{});
}

}  // namespace
}  // namespace pastoso::film::test
