#include "layers/merging.hpp"

#include "layers/apart.hpp"
#include "layers/random_layer.hpp"
#include "layers/sums.hpp"

#include <gtest/gtest.h>

namespace pastoso::layers {
namespace {

using film::FilmState;
using test::Sums;
using test::sums_of;

class Merging : public testing::Test {
  protected:
    core::ThreadPool pool{2};
};

TEST_F(Merging, LosesNoPaintAndNoRelief) {
    for (const double opacity : {1.0, 0.6}) {
        for (std::uint32_t seed = 1; seed < 6; ++seed) {
            const FilmState lower = test::random_layer(seed), upper = test::random_layer(seed + 50);
            const FilmState both = merged(lower, upper, opacity, pool);
            Sums expected = sums_of(lower) + sums_of(upper), found = sums_of(both);
            // What has dried on the way has become relief.
            const std::int64_t dried = film::dried_totals(both.strata).thickness -
                                       film::dried_totals(lower.strata).thickness -
                                       film::dried_totals(upper.strata).thickness;
            expected.relief += dried / film::kQuantaPerSupport;
            EXPECT_EQ(found, expected) << "seed " << seed << ", opacity " << opacity;
            EXPECT_GT(dried, 0);
        }
    }
}

TEST_F(Merging, WithABareLayerChangesNothing) {
    const FilmState layer = test::random_layer(7);
    EXPECT_EQ(film::state_hash(merged(layer, test::bare_layer(), 1.0, pool)), film::state_hash(layer));
    EXPECT_EQ(film::state_hash(merged(test::bare_layer(), layer, 1.0, pool)), film::state_hash(layer));
}

TEST_F(Merging, IsTheSameOnAnyNumberOfThreads) {
    core::ThreadPool alone(1), three(3);
    const FilmState a = test::random_layer(8), b = test::random_layer(9);
    EXPECT_EQ(film::state_hash(merged(a, b, 0.5, alone)), film::state_hash(merged(a, b, 0.5, three)));
}

class MergedCell : public Merging {
  protected:
    void lay(FilmState& layer, double thickness_mm, const pigment::Coefficients& pigment,
             const char* medium = "heavy-body oil") {
        film::test::lay(layer, 0, 0, thickness_mm, pigment, film::find_medium(medium));
    }
    pigment::Bands reflectance(const FilmState& layer) {
        pigment::Bands seen{};
        for (int band = 0; band < pigment::kBands; ++band)
            seen[band] = pigment::reflectance_over(film::optics_of(layer.strata.optics.at(0, 0), band),
                                                   film::test::kWhiteGround[band]);
        return film::test::wet_over(
            layer.paint.at(0, 0).data(),
            film::test::wet_over(layer.strata.soluble_pigment.at(0, 0).data(), seen));
    }
    FilmState lower = test::bare_layer(), upper = test::bare_layer();
};

TEST_F(MergedCell, WetPaintLiesOnWetPaint) {
    lay(lower, 0.2, film::test::kBlue);
    lay(upper, 0.1, film::test::kRed);
    const FilmState both = merged(lower, upper, 1.0, pool);
    EXPECT_EQ(both.thickness.at(0, 0), lower.thickness.at(0, 0) + upper.thickness.at(0, 0));
    EXPECT_EQ(both.paint.at(0, 0)[3], lower.paint.at(0, 0)[3] + upper.paint.at(0, 0)[3]);
    EXPECT_EQ(both.lower.thickness.at(0, 0), lower.thickness.at(0, 0));
    EXPECT_EQ(both.lower.paint.at(0, 0), lower.paint.at(0, 0));
    EXPECT_EQ(both.strata.optics.at(0, 0), film::kClearStrata);
    EXPECT_TRUE(both.consistencies.are_several());
}

TEST_F(MergedCell, MoreThanACellHoldsIsDryBelow) {
    lay(lower, 10.0, film::test::kBlue);
    lay(upper, 8.0, film::test::kRed);
    const FilmState both = merged(lower, upper, 1.0, pool);
    EXPECT_EQ(both.thickness.at(0, 0), upper.thickness.at(0, 0));
    EXPECT_GT(both.support_mm.at(0, 0), 5.0F);
}

TEST_F(MergedCell, WetPaintIsDryBelowStrata) {
    lay(lower, 0.2, film::test::kBlue);
    lay(upper, 0.01, film::test::kRed, "soft-body acrylic");
    film::dry_now(upper, pool);
    lay(upper, 0.1, film::test::kRed);
    const pigment::Bands below =
        film::test::wet_over(lower.paint.at(0, 0).data(), film::test::kWhiteGround);
    const pigment::Bands expected = film::test::wet_over(upper.paint.at(0, 0).data(), [&] {
        pigment::Bands seen{};
        for (int band = 0; band < pigment::kBands; ++band)
            seen[band] = pigment::reflectance_over(film::optics_of(upper.strata.optics.at(0, 0), band),
                                                   below[band]);
        return seen;
    }());
    const FilmState both = merged(lower, upper, 1.0, pool);
    EXPECT_EQ(both.thickness.at(0, 0), upper.thickness.at(0, 0));
    for (int band = 0; band < pigment::kBands; ++band)
        EXPECT_NEAR(reflectance(both)[band], expected[band], film::test::kCodeRounding);
    EXPECT_EQ(both.strata.uppermost.at(0, 0), upper.strata.uppermost.at(0, 0));
}

TEST_F(MergedCell, AFadedLayerIsDryAndFaded) {
    lay(upper, 0.05, film::test::kRed);
    const FilmState both = merged(lower, upper, 0.25, pool);
    EXPECT_EQ(both.thickness.at(0, 0), 0);
    const film::StrataOptics whole = film::laid_over(upper.paint.at(0, 0).data(), film::kClearStrata);
    for (int band = 0; band < pigment::kBands; ++band) {
        EXPECT_NEAR(film::optics_of(both.strata.optics.at(0, 0), band).reflectance,
                    0.25F * film::optics_of(whole, band).reflectance, film::test::kCodeRounding);
        EXPECT_NEAR(film::optics_of(both.strata.optics.at(0, 0), band).transmittance,
                    0.75F + 0.25F * film::optics_of(whole, band).transmittance,
                    film::test::kCodeRounding);
    }
}

}  // namespace
}  // namespace pastoso::layers
