// Every dip gathers the hairs anew: strokes of two dips are no copies of each other, one stroke keeps
// its profile.
#include "brush/brush.hpp"
#include "brush/stroke_group.hpp"
#include "brush/studio.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include <gtest/gtest.h>

namespace pastoso::brush {
namespace {

constexpr double kStart_mm = 25.0, kEnd_mm = 85.0;

struct Case {
    const char* preset;
    double half_band_mm;
};

class Gather : public testing::TestWithParam<Case> {
  protected:
    Brush brush{find_preset(GetParam().preset)};
    double middle_mm = 0.5 * brush.preset.tip.width_mm + 8.0;

    /// A stroke along x with the tip's width across it.
    film::FilmState stroke() {
        film::FilmState film = studio::smooth(110.0, 2.0 * middle_mm);
        StrokeGroup strokes(brush, film, {}, {});
        constexpr int kSamples = 250;
        for (int i = 0; i <= kSamples; ++i) {
            const double t = static_cast<double>(i) / kSamples;
            const PenSample pen{.time_s = t,
                                .x_mm = kStart_mm + t * (kEnd_mm - kStart_mm),
                                .y_mm = middle_mm,
                                .pressure = 0.45,
                                .rotation_deg = 90.0};
            i == 0 ? strokes.begin(pen) : strokes.add(pen);
        }
        strokes.end();
        return film;
    }
    film::FilmState stroke_of_new_dip() {
        brush.clean();
        brush.load(studio::dark_paint(), 1.0);
        return stroke();
    }

    /// Heights across the stroke, mean over 5 mm of its way, without waves longer than 3 mm.
    std::vector<double> profile(const film::FilmState& film, double along_mm) const {
        const double half_mm = GetParam().half_band_mm;
        const double x_mm = kStart_mm + along_mm;
        const grid::Rect band =
            studio::cells_of(film, x_mm, middle_mm - half_mm, x_mm + 5.0, middle_mm + half_mm);
        const int reach = static_cast<int>(1.5 / film.cell_mm);
        std::vector<double> heights, fine;
        for (int y = band.y0 - reach; y < band.y1 + reach; ++y)
            heights.push_back(studio::mean_thickness_mm(film, {band.x0, y, band.x1, y + 1}));
        for (std::size_t i = reach; i + reach < heights.size(); ++i) {
            double mean = 0.0;
            for (std::size_t j = i - reach; j <= i + reach; ++j)
                mean += heights[j] / (2 * reach + 1);
            fine.push_back(heights[i] - mean);
        }
        return fine;
    }
};

double correlation(const std::vector<double>& a, const std::vector<double>& b) {
    double ab = 0.0, aa = 0.0, bb = 0.0, mean_a = 0.0, mean_b = 0.0;
    const auto count = static_cast<double>(a.size());
    for (std::size_t i = 0; i < a.size(); ++i)
        mean_a += a[i] / count, mean_b += b[i] / count;
    for (std::size_t i = 0; i < a.size(); ++i) {
        const double x = a[i] - mean_a, y = b[i] - mean_b;
        ab += x * y, aa += x * x, bb += y * y;
    }
    return ab / std::sqrt(aa * bb);
}

TEST_P(Gather, MakesEveryDipAStrokeOfItsOwn) {
    std::vector<std::vector<double>> profiles;
    for (int dip = 0; dip < 5; ++dip)
        profiles.push_back(profile(stroke_of_new_dip(), 10.0));
    double sum = 0.0;
    int pairs = 0;
    for (std::size_t i = 0; i < profiles.size(); ++i) {
        for (std::size_t j = 0; j < i; ++j, ++pairs)
            sum += correlation(profiles[i], profiles[j]);
    }
    EXPECT_LT(sum / pairs, 0.5);
}

TEST_P(Gather, LastsAlongAStrokeAndIntoTheNext) {
    const film::FilmState film = stroke_of_new_dip();
    EXPECT_GT(correlation(profile(film, 10.0), profile(film, 30.0)), 0.95);
    // A brush that holds less, and hairs that part again: alike, but no copy.
    EXPECT_GT(correlation(profile(film, 10.0), profile(stroke(), 10.0)), 0.3);
}

TEST_P(Gather, IsTheSameForTheSameDipOfTheSamePiece) {
    brush.load(studio::dark_paint(), 1.0);
    const Brush dipped = brush;
    const std::uint64_t once = film::state_hash(stroke());
    brush = Brush(find_preset(GetParam().preset));
    brush.load(studio::dark_paint(), 1.0);
    EXPECT_EQ(brush.gathering, dipped.gathering);
    EXPECT_EQ(film::state_hash(stroke()), once);
}

TEST_P(Gather, IsNoneWithoutPaintOnTheHairs) {
    const Tip made = brush.tip;
    brush.wear(100.0);
    EXPECT_EQ(brush.tip.hairs, made.hairs);
    brush.load(studio::dark_paint(), 0.5);
    EXPECT_NE(brush.tip.hairs, made.hairs);
    brush.wear(1e6);
    EXPECT_EQ(brush.tip.hairs, made.hairs) << "worn away, the tip is its own";
}

INSTANTIATE_TEST_SUITE_P(Presets, Gather,
                         testing::Values(Case{"flat bristle 20", 7.0}, Case{"round bristle 12", 3.0},
                                         Case{"filbert 14", 4.0}, Case{"fan 26", 8.0},
                                         Case{"bright 12", 4.0}, Case{"soft glazing flat 16", 5.0},
                                         Case{"large flat 40", 12.0}, Case{"palette knife 17", 6.0},
                                         Case{"spreading knife 40", 12.0},
                                         Case{"diamond knife 9", 2.4}));

TEST(Gathering, TakesAsMuchInEveryDipAndOtherwiseShared) {
    Brush brush(find_preset("flat bristle 20"));
    const double first = brush.load(studio::dark_paint(), 1.0).volume_mm3;
    const Tip before = brush.tip;
    brush.clean();
    EXPECT_NEAR(brush.load(studio::dark_paint(), 1.0).volume_mm3, first, 1e-12 * first);
    double most_apart = 0.0;
    for (std::size_t i = 0; i < before.bristles.size(); ++i)
        most_apart =
            std::max(most_apart, std::abs(brush.tip.bristles[i].full_dip - before.bristles[i].full_dip));
    EXPECT_GT(most_apart, 0.1);
}

TEST(Gathering, LeavesAKnifesElementsWhereTheyAre) {
    Brush knife(find_preset("palette knife 17"));
    const Tip made = knife.tip;
    knife.load(studio::dark_paint(), 1.0);
    EXPECT_NE(knife.tip.hairs, made.hairs);
    for (std::size_t i = 0; i < made.bristles.size(); ++i)
        EXPECT_EQ(knife.tip.bristles[i].root_x_mm, made.bristles[i].root_x_mm);
}

TEST(Gathering, PutsStreaksOfHalfMixedPaintElsewhere) {
    Brush brush(find_preset("flat bristle 20"));
    const MixedLoad two{studio::dark_paint(), studio::light_paint(), 0.5, 1.0, false};
    std::vector<double> shares[2];
    for (auto& dip : shares) {
        brush.clean();
        brush.load(two, 1.0);
        for (const Contents& held : brush.held)
            dip.push_back(held.paint[6] / held.volume_mm3);
    }
    EXPECT_LT(correlation(shares[0], shares[1]), 0.5);
}

}  // namespace
}  // namespace pastoso::brush
