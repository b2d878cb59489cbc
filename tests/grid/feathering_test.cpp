#include "grid/feathering.hpp"

#include "core/random.hpp"
#include "grid/drawn_mask.hpp"

#include <cmath>

#include <gtest/gtest.h>

namespace pastoso::grid {
namespace {

/// More than one tile, and none of them whole.
constexpr Shape kOdd = {71, 67};

Mask left_half(Shape shape, double width) {
    const double height = shape.height;
    return polygon_mask(shape, {{0, 0}, {width, 0}, {width, height}, {0, height}});
}

/// How much of a straight edge's near side the weight of three boxes sees, `way` reaches beyond the
/// edge.
double slope_at(double way) {
    const double u = 1.5 * std::abs(way);
    const double beyond = u < 0.5   ? 0.5 - 0.75 * u + u * u * u / 3.0
                          : u < 1.5 ? std::pow(1.5 - u, 3.0) / 6.0
                                    : 0.0;
    return way > 0.0 ? beyond : 1.0 - beyond;
}

bool same(const Mask& a, const Mask& b) {
    for (int y = 0; y < a.shape().height; ++y)
        for (int x = 0; x < a.shape().width; ++x)
            if (a.at(x, y) != b.at(x, y)) return false;
    return true;
}

Mask turned_about(const Mask& mask) {
    Mask other(mask.shape());
    for (int y = 0; y < mask.shape().height; ++y)
        for (int x = 0; x < mask.shape().width; ++x)
            other.set(mask.shape().width - 1 - x, mask.shape().height - 1 - y, mask.at(x, y));
    return other;
}

TEST(Feathering, AStraightEdgeBecomesASlopeOfTheSameMiddle) {
    for (const double reach : {3.3, 12.0, 30.7}) {
        const Mask soft = feathered(left_half({160, 9}, 80), reach);
        // Cells are boxes of their own: they widen the weight's variance, a ninth of its reach squared,
        // by at most a quarter; 0.242 is the largest curvature of such a slope of variance 1.
        const double tolerance = 1.5 + 0.5 * 0.25 * 0.242 * 9.0 / (reach * reach) * 255.0;
        for (int x = 0; x < 160; ++x)
            ASSERT_NEAR(soft.at(x, 4), 255.0 * slope_at((x + 0.5 - 80.0) / reach), tolerance)
                << reach << ": " << x;
    }
}

TEST(Feathering, FallsFromWholeToNothing) {
    const Mask soft = feathered(left_half({160, 9}, 80), 20.0);
    EXPECT_EQ(soft.at(80 - 22, 4), kWhole);
    EXPECT_EQ(soft.at(80 + 22, 4), 0);
    for (int x = 1; x < 160; ++x)
        ASSERT_LE(soft.at(x, 4), soft.at(x - 1, 4)) << x;
    // Both are rounded.
    for (int x = 0; x < 80; ++x)
        ASSERT_NEAR(soft.at(x, 4) + soft.at(159 - x, 4), 255, 1) << x;
    EXPECT_TRUE(is_chosen(soft.at(79, 4)));
    EXPECT_FALSE(is_chosen(soft.at(80, 4)));
}

TEST(Feathering, TheEdgeOfTheCanvasIsNone) {
    const Mask soft = feathered(left_half({160, 70}, 80), 20.0);
    for (int x = 0; x < 160; ++x)
        for (const int y : {0, 35, 69})
            ASSERT_EQ(soft.at(x, y), soft.at(x, 4)) << x << ", " << y;
    EXPECT_EQ(soft.at(0, 0), kWhole);
    const Mask all = inverted(Mask(kOdd));
    EXPECT_TRUE(same(feathered(all, 15.0), all));
    EXPECT_TRUE(same(feathered(Mask(kOdd), 15.0), Mask(kOdd)));
    EXPECT_TRUE(same(feathered(all, 1e9), all));
}

TEST(Feathering, KeepsWhatIsChosenInAll) {
    const Mask box = polygon_mask({90, 90}, {{40, 35}, {60, 35}, {60, 50}, {40, 50}});
    const Mask soft = feathered(box, 18.0);
    double sum = 0.0;
    for (int y = 0; y < 90; ++y)
        for (int x = 0; x < 90; ++x)
            sum += soft.at(x, y);
    // Half a 255th is lost or won in each of the cells that it reaches.
    EXPECT_NEAR(sum, 255.0 * 20 * 15, 0.5 * 58 * 53);
    EXPECT_TRUE(is_soft(soft));
}

TEST(Feathering, OfAMirroredMaskIsMirrored) {
    Mask speckles(kOdd);
    for (int y = 0; y < kOdd.height; ++y)
        for (int x = 0; x < kOdd.width; ++x)
            if (core::uniform_noise(static_cast<std::uint32_t>(y * kOdd.width + x), 4) < 0.3F)
                speckles.set(x, y, kWhole);
    for (const double reach : {2.0, 7.3, 400.0})
        EXPECT_TRUE(
            same(turned_about(feathered(speckles, reach)), feathered(turned_about(speckles), reach)))
            << reach;
}

TEST(Feathering, LessThanACellAndAHalfChangesNothing) {
    Mask dot({9, 7});
    dot.set(4, 3, kWhole);
    for (const double reach : {0.0, 0.4, 1.4})
        EXPECT_TRUE(same(feathered(dot, reach), dot)) << reach;
    EXPECT_FALSE(same(feathered(dot, 2.0), dot));
}

TEST(Feathering, TwiceIsSofter) {
    const Mask once = feathered(left_half({160, 9}, 80), 15.0), twice = feathered(once, 15.0);
    EXPECT_GT(once.at(72, 4), twice.at(72, 4));
    EXPECT_LT(once.at(90, 4), twice.at(90, 4));
}

}  // namespace
}  // namespace pastoso::grid
