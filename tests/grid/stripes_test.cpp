#include "grid/stripes.hpp"

#include "core/random.hpp"
#include "grid/drawn_mask.hpp"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

namespace pastoso::grid {
namespace {

using enum StripeEnds;

TEST(Stripes, AreRoundOrStraightAtTheirEnds) {
    EXPECT_EQ(drawn(stripe_mask({10, 5}, {{2.5, 2.5}, {6.5, 2.5}}, 2.0, Round)),
              "..#####...\n"
              ".#######..\n"
              "#########.\n"
              ".#######..\n"
              "..#####...\n");
    EXPECT_EQ(drawn(stripe_mask({10, 5}, {{2.5, 2.5}, {6.5, 2.5}}, 1.4, Straight)),
              "..........\n"
              "..#####...\n"
              "..#####...\n"
              "..#####...\n"
              "..........\n");
}

TEST(Stripes, OfAPointAreADiscOrNothing) {
    EXPECT_EQ(drawn(stripe_mask({5, 3}, {{2.5, 1.5}}, 1.0, Round)),
              "..#..\n"
              ".###.\n"
              "..#..\n");
    EXPECT_EQ(chosen_cells(stripe_mask({5, 3}, {{2.5, 1.5}}, 1.0, Straight)), 0);
    EXPECT_EQ(chosen_cells(stripe_mask({5, 3}, {{-9.0, 1.5}, {-4.0, 40.0}}, 2.0, Round)), 0);
}

/// The distance of a point from a piece of a line.
double distance(const Point& p, const Point& a, const Point& b) {
    const double dx = b.x - a.x, dy = b.y - a.y, square = dx * dx + dy * dy;
    const double along =
        square == 0.0 ? 0.0 : std::clamp(((p.x - a.x) * dx + (p.y - a.y) * dy) / square, 0.0, 1.0);
    return std::hypot(p.x - a.x - along * dx, p.y - a.y - along * dy);
}

TEST(Stripes, TakeTheCellsNearTheLineAndNoOthers) {
    constexpr Shape kOdd{71, 67};
    std::vector<Point> line;
    for (std::uint32_t i = 0; i < 12; ++i)
        line.push_back(
            {90.0 * core::uniform_noise(i, 1) - 10.0, 90.0 * core::uniform_noise(i, 2) - 10.0});
    line.push_back(line.back());
    const double radius = 3.3;
    const Mask mask = stripe_mask(kOdd, line, radius, Round);
    for (int y = 0; y < kOdd.height; ++y)
        for (int x = 0; x < kOdd.width; ++x) {
            double nearest = 1e9;
            for (std::size_t i = 0; i + 1 < line.size(); ++i)
                nearest = std::min(nearest, distance({x + 0.5, y + 0.5}, line[i], line[i + 1]));
            // Rounding decides where a centre lies on the border to 1e-9.
            if (std::abs(nearest - radius) > 1e-9) {
                ASSERT_EQ(mask.at(x, y) != 0, nearest < radius) << x << ", " << y;
            }
        }
}

TEST(Stripes, AreMirroredByAMirroredLine) {
    constexpr Shape kSquare{40, 40};
    for (const StripeEnds ends : {Round, Straight}) {
        const Mask mask = stripe_mask(kSquare, {{5, 8}, {30, 12.5}, {18, 33}}, 4.25, ends);
        const Mask other = stripe_mask(kSquare, {{22, 33}, {10, 12.5}, {35, 8}}, 4.25, ends);
        for (int y = 0; y < kSquare.height; ++y)
            for (int x = 0; x < kSquare.width; ++x)
                ASSERT_EQ(mask.at(x, y), other.at(39 - x, y)) << x << ", " << y;
    }
}

}  // namespace
}  // namespace pastoso::grid
