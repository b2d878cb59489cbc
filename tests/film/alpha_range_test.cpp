// The drag of the alpha range: how it follows the surface tension, and where it must not.
#include "film/face/face_physics.hpp"
#include "film/film_bench.hpp"

#include <array>
#include <cmath>

#include <gtest/gtest.h>

namespace pastoso::film::test {
namespace {

constexpr float kAgainst = 12.0F, kAlong = 2.3077F;  // alpha 0.5 and 1.2

/// Drag at a face of this slope along the flow, on a convex or a hollow surface.
float drag_on(float slope, float curvature, float speed = 1.0F) {
    StepConstants step;
    step.drag_against = kAgainst;
    step.drag_along = kAlong;
    FaceNeighbourhood<float> face{};
    face.eta_right = slope;
    face.curvature = curvature;
    face.u = speed;
    return alpha_drag(face, FacePaint<float, FaceModel{}>{}, step);
}

// A drop's front falls along the flow and is convex: its tension points back into the drop.
TEST(AlphaRange, TensionHoldsFrontsBackAndPushesTheRear) {
    const float mean = 0.5F * (kAgainst + kAlong), half = 0.5F * (kAgainst - kAlong);
    constexpr float kSteep = 1e3F;
    EXPECT_NEAR(drag_on(-kSteep, 0.3F), kAgainst, 0.01);
    EXPECT_NEAR(drag_on(kSteep, 0.3F), kAlong, 0.01);
    EXPECT_NEAR(drag_on(-kSteep, -0.3F), kAlong, 0.01);
    EXPECT_NEAR(drag_on(-kSteep, 0.3F, -1.0F), kAlong, 0.01);
    // At 45 degrees the normal leans by as much.
    EXPECT_NEAR(drag_on(-1.0F, 0.3F), mean + std::sqrt(0.5F) * half, 0.01);
}

TEST(AlphaRange, LevelAndStillPaintHasTheMeanDrag) {
    const float mean = 0.5F * (kAgainst + kAlong);
    EXPECT_FLOAT_EQ(drag_on(0.0F, 0.3F), mean);
    EXPECT_FLOAT_EQ(drag_on(-0.5F, 0.0F), mean);
    EXPECT_FLOAT_EQ(drag_on(-0.5F, 0.3F, 0.0F), mean);
    // It gets there evenly: twice the slope, twice the effect.
    const float gentle = drag_on(-0.001F, 0.3F) - mean;
    EXPECT_NEAR((drag_on(-0.002F, 0.3F) - mean) / gentle, 2.0, 1e-3);
}

/// 1/16 of the fourth difference: what alternates from cell to cell.
double alternating(const std::array<double, 5>& h) {
    return std::abs(h[0] - 4 * h[1] + 6 * h[2] - 4 * h[3] + h[4]) / 16;
}

/// Root mean square over a periodic film of what alternates along both axes, mm.
double streaks(const Bench& bench) {
    const int width = bench.setup.width, height = bench.setup.height;
    double squares = 0;
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            std::array<double, 5> row{}, column{};
            for (int k = 0; k < 5; ++k) {
                row[k] = bench.h((x + k) % width, y);
                column[k] = bench.h(x, (y + k) % height);
            }
            squares += std::pow(alternating(row), 2) + std::pow(alternating(column), 2);
        }
    return std::sqrt(squares / (width * height));
}

// A swell runs over a film without edges. Paint that is all but level stays smooth: as smooth as under
// one alpha of the same mean drag, 0.0013 mm. A drag that follows the tension's direction however small
// the slope leaves 0.0056 mm.
TEST(AlphaRange, LeavesNoStreaks) {
    Bench bench({.width = 48,
                 .height = 64,
                 .gravity = 0.2,
                 .force_y = 2,
                 .viscosity = 0.5,
                 .tension = 20,
                 .alpha_min = 0.5,
                 .alpha_max = 1.2});
    bench.fill([](int x, int y) {
        return 1.2 + 1.5 * std::exp(-(std::pow(x - 20.3, 2) + std::pow(y - 20.7, 2)) / 98);
    });
    bench.run(0.01, 8.0);
    EXPECT_LT(streaks(bench), 0.002);  // reached 0.0012
}

}  // namespace
}  // namespace pastoso::film::test
