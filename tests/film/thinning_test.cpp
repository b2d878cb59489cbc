// Paint from paste to stain: each number of a thinned medium against its law, and that it comes through
// from the whole paint to the stain without a jump.

#include "film/thinning.hpp"

#include "film/cell/paint_cell.hpp"

#include <cmath>

#include <gtest/gtest.h>

namespace pastoso::film::test {
namespace {

TEST(Thinning, FollowsTheLawOfEachNumber) {
    const Medium& oil = find_medium("heavy-body oil");
    const Medium& thinner = find_medium("thinner");
    const Medium half = thinned(oil, 0.5);
    EXPECT_NEAR(half.viscosity_m2_s, std::sqrt(oil.viscosity_m2_s * thinner.viscosity_m2_s), 1e-12);
    EXPECT_DOUBLE_EQ(half.yield_stress_Pa, oil.yield_stress_Pa / 8.0);
    EXPECT_DOUBLE_EQ(half.pigment_share, 0.5);
    EXPECT_DOUBLE_EQ(half.solid_fraction, 0.5 * (oil.solid_fraction + thinner.solid_fraction));
    EXPECT_DOUBLE_EQ(half.density_kg_m3, 0.5 * (oil.density_kg_m3 + thinner.density_kg_m3));
    EXPECT_EQ(half.name, oil.name);
}

TEST(Thinning, LeavesWholePaintAndWhatNothingThinsAsTheyAre) {
    for (const Medium& medium : bundled_media())
        EXPECT_EQ(thinned(medium, 1.0), medium);
    EXPECT_EQ(thinned(find_medium("thinner"), 0.3), find_medium("thinner"));
}

TEST(Thinning, EveryStainIsAMedium) {
    for (const Medium& medium : bundled_media()) {
        for (const double share : {kLeastPaintShare, 0.1, 0.37, 0.999})
            EXPECT_NO_THROW(check_numbers(thinned(medium, share), core::Message::verbatim(medium.name)))
                << share;
    }
}

TEST(Thinning, GetsRunnierAndPalerAllTheWay) {
    for (const Medium& medium : bundled_media()) {
        if (medium.thinned_with.empty()) continue;
        Medium before = medium;
        for (double share = 0.95; share > kLeastPaintShare; share -= 0.05) {
            const Medium thin = thinned(medium, share);
            EXPECT_LT(thin.viscosity_m2_s, before.viscosity_m2_s) << medium.name << share;
            EXPECT_LE(thin.yield_stress_Pa, before.yield_stress_Pa) << medium.name << share;
            EXPECT_LT(thin.pigment_share, before.pigment_share) << medium.name << share;
            before = thin;
        }
    }
}

TEST(Thinning, ColoursAsMuchAsThePigmentThatIsLeft) {
    pigment::Coefficients strong{};
    for (int k = 0; k < pigment::kChannels; ++k)
        strong[static_cast<std::size_t>(k)] = 8.0F * static_cast<float>(k + 1);
    const PaintCoefficients whole = paint_coefficients(strong, find_medium("heavy-body oil"));
    const PaintCoefficients thin =
        paint_coefficients(strong, thinned(find_medium("heavy-body oil"), 0.25));
    for (int k = 0; k < kPigmentChannels; ++k)
        EXPECT_EQ(thin[static_cast<std::size_t>(k)], 0.25F * whole[static_cast<std::size_t>(k)]);
}

}  // namespace
}  // namespace pastoso::film::test
