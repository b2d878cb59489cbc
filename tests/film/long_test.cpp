// The slower half of the validation: many steps, fine grids, many random paints. Label `long`.
#include "film/film_bench.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

namespace pastoso::film::test {
namespace {

using std::numbers::pi;

// A drop at rest without gravity: a spherical cap with the contact angle's slope at its edge.
struct CapCase {
    double slope;
    int refinement;
};
class SessileCap : public testing::TestWithParam<CapCase> {};

double radius_at(const Bench& bench, double height, double direction_x, double direction_y) {
    const double centre = bench.setup.width / 2.0;
    for (double r = 0; r < centre; r += 0.02) {
        const double x = centre + r * direction_x - 0.5, y = centre + r * direction_y - 0.5;
        const int i = static_cast<int>(x), j = static_cast<int>(y);
        const double s = x - i, t = y - j;
        const double h = (1 - t) * ((1 - s) * bench.h(i, j) + s * bench.h(i + 1, j)) +
                         t * ((1 - s) * bench.h(i, j + 1) + s * bench.h(i + 1, j + 1));
        if (h < height) return r * bench.setup.cell_mm;
    }
    return 0.0;
}

TEST_P(SessileCap, TakesTheRadiusAndHeightOfItsAngle) {
    const auto [slope, refinement] = GetParam();
    constexpr double kRadius = 10, kStartRadius = 7;
    const double dx = 1.0 / refinement;
    const double top = kRadius * std::tan(std::atan(slope) / 2);
    const double volume = pi * top / 6 * (3 * kRadius * kRadius + top * top);
    const int n = 32 * refinement;
    Bench bench({.width = n,
                 .height = n,
                 .cell_mm = dx,
                 .tension = 10,
                 .tan_advancing = slope,
                 .tan_receding = slope,
                 .slip_cells = 0.2,
                 .full_curvature = true});
    const double start_top = 2 * volume / (pi * kStartRadius * kStartRadius);
    bench.fill([&](int x, int y) {
        const double r = std::hypot((x + 0.5) * dx - 16, (y + 0.5) * dx - 16) / kStartRadius;
        return r < 1 ? start_top * (1 - r * r) : 0.0;
    });
    bench.run(0.4 * bench.solver->stable_step_s(start_top), refinement == 1 ? 60.0 : 30.0);

    double covered = 0;
    for (int y = 0; y < n; ++y)
        for (int x = 0; x < n; ++x)
            covered += std::min(1.0, std::sqrt(std::max(bench.h(x, y), 0.0) * 2 / (dx * slope)));
    const double radius = std::sqrt(covered * dx * dx / pi);
    EXPECT_NEAR(radius / kRadius, 1.0, 0.03);     // reached 0.5 to 1.1 %
    EXPECT_NEAR(bench.max_h() / top, 1.0, 0.06);  // reached 2 to 4.5 %
    const double along = radius_at(bench, 0.3 * top, 1, 0);
    const double slanted = radius_at(bench, 0.3 * top, std::sqrt(0.5), std::sqrt(0.5));
    EXPECT_NEAR(along / slanted, 1.0, 0.02);  // reached 0.9 to 1.4 %
}
INSTANTIATE_TEST_SUITE_P(Angles, SessileCap,
                         testing::Values(CapCase{0.3, 1}, CapCase{0.6, 1}, CapCase{1.0, 1},
                                         CapCase{0.6, 2}));

// A drop too large for its tension flattens to the puddle thickness tan(theta) sqrt(sigma / (rho g)),
// here 1.
TEST(Puddle, HasTheCapillaryThickness) {
    const int n = 80;
    Bench bench({.width = n,
                 .height = n,
                 .gravity = 10,
                 .tension = 40,
                 .tan_advancing = 0.5,
                 .tan_receding = 0.5,
                 .slip_cells = 0.2});
    bench.fill([](int x, int y) {
        const double r = std::hypot(x + 0.5 - 40, y + 0.5 - 40) / 24;
        return r < 1 ? 1.6 * (1 - r * r * r * r) : 0.0;
    });
    bench.run(0.4 * bench.solver->stable_step_s(1.7), 60.0);
    EXPECT_NEAR(bench.h(40, 40), 1.0, 0.1);  // 5 % of discretisation, 5 % of the finite radius
}

TEST(RippleDecay, CapillaryOnAFineGrid) {
    const int n = 64;
    const double k = 2 * pi / n, rate = 20 * k * k * k * k / 30;
    Bench bench(
        {.width = n, .height = 4, .viscosity = 10, .tension = 20, .inertia = false, .lateral = false});
    bench.fill([k](int x, int) { return 1 + 0.05 * std::cos(k * (x + 0.5)); });
    const auto amplitude = [&] {
        double cosine = 0;
        for (int x = 0; x < n; ++x)
            cosine += bench.h(x, 1) * std::cos(k * (x + 0.5)) * 2 / n;
        return cosine;
    };
    const double before = amplitude();
    const double dt = 0.5 * bench.solver->stable_step_s(1.0), seconds = std::ceil(0.3 / rate / dt) * dt;
    bench.run(dt, seconds);
    EXPECT_NEAR(std::log(before / amplitude()) / seconds / rate, 1.0, 0.015);  // reached 0.75 %
}

// Not one quantum of paint or pigment is lost in a hundred thousand steps.
TEST(Conservation, IsExactOverAHundredThousandSteps) {
    Bench bench({.width = 64,
                 .height = 64,
                 .gravity = 1,
                 .force_x = 0.3,
                 .force_y = 0.1,
                 .tension = 2,
                 .yield = 0.01,
                 .alpha_min = 0.5,
                 .alpha_max = 1.2});
    bench.fill([](int x, int y) { return 1 + 0.7 * std::sin(x * 0.3) * std::cos(y * 0.2); });
    bench.tint(0, [](int x, int) { return x < 32 ? 150.0 : 0.0; });
    bench.tint(11, [](int, int y) { return y < 32 ? 0.003 : 40.0; });
    const Totals before = totals(bench.state);
    for (int i = 0; i < 100000; ++i)
        bench.solver->step(0.05);
    const Totals after = totals(bench.state);
    EXPECT_EQ(after.thickness, before.thickness);
    EXPECT_EQ(after.paint, before.paint);
}

}  // namespace
}  // namespace pastoso::film::test
