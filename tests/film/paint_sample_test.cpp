#include "film/cell/paint_sample.hpp"

#include "core/thread_pool.hpp"
#include "film/cell/drying.hpp"
#include "film/dry_film.hpp"

#include <gtest/gtest.h>

namespace pastoso::film::test {
namespace {

using pigment::Coefficients;

/// 4 x 4 cells of a quarter of a millimetre.
class PaintSampleTest : public ::testing::Test {
  protected:
    FilmState film{{4, 4}, 0.25};
    const Medium& oil = find_medium("heavy-body oil");
    core::ThreadPool pool{1};

    void dry_all() { dry_now(film, pool); }
    PaintSample at(double x_mm, double y_mm, double radius_mm = 0.0) {
        return sample_paint(film, x_mm, y_mm, radius_mm);
    }
};

void expect_close(const Coefficients& found, const Coefficients& expected, double relative) {
    for (int k = 0; k < pigment::kChannels; ++k)
        EXPECT_NEAR(found[k] / expected[k], 1.0, relative) << k;
}

/// A channel of 1 per mm in a tenth of a millimetre is 13107 quanta, rounded by half of one.
constexpr double kWholeQuanta = 2e-4;
/// 16 bits on a scale of square roots, at the 0.4 per mm that is the least here.
constexpr double kSixteenBits = 1e-3;

TEST_F(PaintSampleTest, OfABareCanvasIsNothing) {
    EXPECT_EQ(at(0.5, 0.5, 1.0).layer, PaintLayer::Bare);
    EXPECT_EQ(at(-3.0, 0.5).layer, PaintLayer::Bare);
}

TEST_F(PaintSampleTest, OfOneWetCellIsItsPaint) {
    lay(film, 1, 2, 0.1, kBlue, oil);
    lay(film, 2, 2, 0.1, kRed, oil);
    const PaintSample sample = at(0.3, 0.6);
    EXPECT_EQ(sample.layer, PaintLayer::Wet);
    expect_close(sample.coefficients, kBlue, kWholeQuanta);
}

TEST_F(PaintSampleTest, OfADiscIsTheMeanByVolume) {
    lay(film, 1, 1, 0.3, kBlue, oil);
    lay(film, 2, 1, 0.1, kRed, oil);
    // The disc holds the middles of four cells, two of them bare.
    const PaintSample sample = at(0.5, 0.5, 0.2);
    Coefficients expected{};
    for (int k = 0; k < pigment::kChannels; ++k)
        expected[k] = 0.75F * kBlue[k] + 0.25F * kRed[k];
    expect_close(sample.coefficients, expected, kWholeQuanta);
}

TEST_F(PaintSampleTest, OfDryPaintIsTheUppermostStratum) {
    lay(film, 1, 1, 0.2, kBlue, oil);
    dry_all();
    EXPECT_EQ(at(0.3, 0.3).layer, PaintLayer::Dry);
    expect_close(at(0.3, 0.3).coefficients, kBlue, kSixteenBits);
    lay(film, 1, 1, 0.2, kRed, oil);
    dry_all();
    expect_close(at(0.3, 0.3).coefficients, kRed, kSixteenBits);
    EXPECT_EQ(at(0.6, 0.3).layer, PaintLayer::Bare);
}

TEST_F(PaintSampleTest, WetPaintCoversDry) {
    lay(film, 1, 1, 0.2, kBlue, oil);
    dry_all();
    lay(film, 1, 1, 0.2, kRed, oil);
    EXPECT_EQ(at(0.3, 0.3).layer, PaintLayer::Wet);
    expect_close(at(0.3, 0.3).coefficients, kRed, kWholeQuanta);
}

TEST_F(PaintSampleTest, AWetTraceOverDryPaintIsOverlookedAndOnBareCanvasIsNot) {
    lay(film, 1, 1, 0.2, kBlue, oil);
    dry_all();
    lay(film, 1, 1, 0.004, kRed, oil);
    lay(film, 2, 1, 0.004, kRed, oil);
    EXPECT_EQ(at(0.3, 0.3).layer, PaintLayer::Dry);
    EXPECT_EQ(at(0.6, 0.3).layer, PaintLayer::Wet);
}

/// A cell of two wet strata.
void lay_both(FilmState& film, double lower_mm, double upper_mm, const Medium& medium) {
    lay(film, 1, 1, upper_mm, kRed, medium);
    const std::int32_t upper_thickness = film.thickness.at(1, 1);
    const PaintCell upper = film.paint.at(1, 1);
    lay(film, 1, 1, lower_mm, kBlue, medium);
    film.lower.thickness.set(1, 1, film.thickness.at(1, 1));
    film.lower.paint.set(1, 1, film.paint.at(1, 1));
    PaintCell whole = film.paint.at(1, 1);
    for (std::size_t k = 0; k < whole.size(); ++k)
        whole[k] += upper[k];
    film.thickness.set(1, 1, film.thickness.at(1, 1) + upper_thickness);
    film.paint.set(1, 1, whole);
}

TEST_F(PaintSampleTest, OfTwoWetStrataIsTheUpperOne) {
    lay_both(film, 0.3, 0.1, oil);
    const PaintSample sample = at(0.3, 0.3);
    EXPECT_EQ(sample.layer, PaintLayer::Wet);
    expect_close(sample.coefficients, kRed, kWholeQuanta);
}

TEST_F(PaintSampleTest, AWetTraceOverWetPaintIsPickedWithIt) {
    lay_both(film, 0.297, 0.003, oil);
    Coefficients mixed{};
    for (int k = 0; k < pigment::kChannels; ++k)
        mixed[k] = 0.99F * kBlue[k] + 0.01F * kRed[k];
    expect_close(at(0.3, 0.3).coefficients, mixed, 5.0 * kWholeQuanta);
}

TEST_F(PaintSampleTest, PaintThatCanBeDissolvedIsUppermost) {
    lay(film, 1, 1, 0.2, kBlue, oil);
    dry_all();
    lay(film, 1, 1, 0.08, kRed, find_medium("ink glaze"));
    dry_all();
    const Coefficients found = at(0.3, 0.3).coefficients;
    // The solvent has gone: the proportions are what is left of the ink.
    const double denser = found[3] / kRed[3];
    for (int k = 0; k < pigment::kChannels; ++k)
        EXPECT_NEAR(found[k] / denser / kRed[k], 1.0, 5.0 * kSixteenBits) << k;
}

TEST(PigmentMixture, IsTheSameForAnyThicknessAndEmptyWithoutOne) {
    const PaintCell thin = cell_of(paint_coefficients(kRed, find_medium("heavy-body oil")), 0.25);
    const PaintCell thick = cell_of(paint_coefficients(kRed, find_medium("heavy-body oil")), 2.0);
    EXPECT_EQ(mixture_of(thin.data(), quanta_of(0.25)), mixture_of(thick.data(), quanta_of(2.0)));
    EXPECT_EQ(mixture_of(thin.data(), 0), PigmentMixture{});
}

}  // namespace
}  // namespace pastoso::film::test
