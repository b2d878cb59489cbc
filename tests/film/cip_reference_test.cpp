// The reference of the paper's scheme, tried on its own: it must be a good example of its kind.
#include "film/cip_reference.hpp"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

namespace pastoso::film::test {
namespace {

using std::numbers::pi;

constexpr double kSide = 1.0;

/// A smooth periodic pulse with its derivatives.
double pulse(double x, double y) {
    return std::exp(std::cos(2 * pi * x) + 0.5 * std::sin(2 * pi * y));
}
double pulse_slope_x(double x, double y) {
    return -2 * pi * std::sin(2 * pi * x) * pulse(x, y);
}
double pulse_slope_y(double x, double y) {
    return pi * std::cos(2 * pi * y) * pulse(x, y);
}

struct AdvectionError {
    double value = 0, slope = 0;
};

/// Mean errors after the pulse has gone once around in x and, the other way, twice in y.
AdvectionError advection_error(int n) {
    const CipGrid grid{n, n, kSide / n};
    CipField field(grid.count());
    for (int y = 0; y < n; ++y)
        for (int x = 0; x < n; ++x) {
            const int i = grid.index(x, y);
            field.value[i] = pulse(x * grid.spacing, y * grid.spacing);
            field.slope_x[i] = pulse_slope_x(x * grid.spacing, y * grid.spacing);
            field.slope_y[i] = pulse_slope_y(x * grid.spacing, y * grid.spacing);
        }
    const CipField exact = field;
    const std::vector<double> u(grid.count(), 1.0), v(grid.count(), -2.0);
    const int steps = 5 * n;  // Courant numbers 0.2 and 0.4
    for (int k = 0; k < steps; ++k)
        field = advected(grid, field, u, v, 1.0 / steps);
    AdvectionError error;
    for (int i = 0; i < grid.count(); ++i) {
        error.value += std::abs(field.value[i] - exact.value[i]) / grid.count();
        error.slope += std::abs(field.slope_x[i] - exact.slope_x[i]) / grid.count();
    }
    return error;
}

// A cubic leaves an error of fourth order in each of O(n) steps: third order in all. Its derivative is
// of one order less in one step; evolved with the values it keeps up with them.
TEST(CipAdvection, IsOfThirdOrder) {
    AdvectionError previous = advection_error(16);
    for (const int n : {32, 64}) {
        const AdvectionError error = advection_error(n);
        const double order = std::log2(previous.value / error.value);
        const double slope_order = std::log2(previous.slope / error.slope);
        EXPECT_NEAR(order, 3.0, 0.25) << n;       // reached 2.87 and 2.97
        EXPECT_NEAR(slope_order, 3.0, 0.3) << n;  // reached 2.80 and 2.96
        previous = error;
    }
}

TEST(CipReference, UniformFilmAtRestStaysAtRest) {
    CipReference cip({12, 9, 1.0}, {.gravity = 5, .tension = 4, .alpha_min = 0.5, .alpha_max = 1.2});
    cip.set_film([](int, int) { return 1.5; });
    for (int k = 0; k < 200; ++k)
        cip.step(0.004);
    for (int y = 0; y < 9; ++y)
        for (int x = 0; x < 12; ++x) {
            ASSERT_EQ(cip.h(x, y), 1.5);
            ASSERT_EQ(cip.u(x, y), 0.0);
            ASSERT_EQ(cip.v(x, y), 0.0);
        }
}

TEST(CipReference, LakeOverSubmergedSupportStaysAtRest) {
    CipReference cip({16, 16, 1.0}, {.gravity = 5, .tension = 4});
    const auto support = [](int x, int y) { return 0.0625 * ((x * 7 + y * 3) % 8); };
    cip.set_support(support);
    cip.set_film([&](int x, int y) { return 2 - support(x, y); });
    for (int k = 0; k < 200; ++k)
        cip.step(0.004);
    for (int y = 0; y < 16; ++y)
        for (int x = 0; x < 16; ++x)
            ASSERT_EQ(cip.h(x, y) + support(x, y), 2.0);
}

// F h^2 (3 alpha - 1) / (6 nu); on a flat film the cosine is 0 and k_d the mean of its two ends.
TEST(CipReference, ReachesNusseltsVelocity) {
    const auto terminal_velocity = [](double alpha_min, double alpha_max) {
        CipReference cip({8, 4, 1.0}, {.gravity = 1,
                                       .tension = 2,
                                       .viscosity = 1.5,
                                       .force_x = 0.1,
                                       .force_y = -0.2,
                                       .alpha_min = alpha_min,
                                       .alpha_max = alpha_max});
        cip.set_film([](int, int) { return 2.0; });
        for (int k = 0; k < 4000; ++k)
            cip.step(0.02);
        EXPECT_NEAR(cip.v(1, 1), -2 * cip.u(1, 1), 1e-12);
        EXPECT_NEAR(cip.volume(), 64.0, 1e-9);
        return cip.u(1, 1);
    };
    for (const double alpha : {0.5, 1.0, 1.2})
        EXPECT_NEAR(terminal_velocity(alpha, alpha), 0.1 * 4 * (3 * alpha - 1) / (6 * 1.5), 1e-10);
    const double mean_drag = (12.0 + 6.0 / 2.6) / 2;
    EXPECT_NEAR(terminal_velocity(0.5, 1.2), 0.1 * 4 / (mean_drag * 1.5), 1e-10);
}

// A ripple decays at h^3 (g k^2 + sigma/rho k^4) / (3 nu).
TEST(CipReference, LevelsAtTheLinearRate) {
    const int n = 32;
    const double k = 2 * pi / n, viscosity = 4, tension = 20, dt = 0.02;
    CipReference cip({n, 3, 1.0}, {.gravity = 1, .tension = tension, .viscosity = viscosity});
    cip.set_film([&](int x, int) { return 1 + 0.02 * std::cos(k * x); });
    const auto amplitude = [&] {
        double sum = 0;
        for (int x = 0; x < n; ++x)
            sum += cip.h(x, 1) * std::cos(k * x) * 2 / n;
        return sum;
    };
    const double rate = (k * k + tension * k * k * k * k) / (3 * viscosity);
    const int steps = static_cast<int>(0.7 / rate / dt);
    const double before = amplitude();
    for (int step = 0; step < steps; ++step)
        cip.step(dt);
    const double measured = std::log(before / amplitude()) / (steps * dt);
    // Centred differences over two cells lose 2 (k dx)^2 / 6 = 1.3 %, lateral viscosity (k h)^2 / 3 the
    // same, and the ripple takes 1/(3 nu) of its time to start.
    EXPECT_NEAR(measured / rate, 1.0, 0.05);
}

}  // namespace
}  // namespace pastoso::film::test
