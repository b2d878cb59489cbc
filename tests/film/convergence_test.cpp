// Order of convergence without an exact solution: smooth waves that level and run down a bumpy support
// in both directions, each grid against the next finer one.
#include "film/film_bench.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include <gtest/gtest.h>

namespace pastoso::film::test {
namespace {

using std::numbers::pi;

constexpr double kLength_mm = 64, kSeconds = 6;

/// Mean of sin(k x + phase) over [a, b].
double mean_sine(double k, double phase, double a, double b) {
    return (std::cos(k * a + phase) - std::cos(k * b + phase)) / (k * (b - a));
}

struct Physics {
    const char* name;
    bool inertia = false;
    double yield = 0;
};

std::vector<double> waves(const Physics& physics, int n) {
    const double cell = kLength_mm / n, k = 2 * pi / kLength_mm;
    Bench bench({.width = n,
                 .height = n,
                 .cell_mm = cell,
                 .gravity = 1,
                 .force_x = 0.3,
                 .force_y = -0.2,
                 .tension = 0.5,
                 .yield = physics.yield,
                 .inertia = physics.inertia,
                 .lateral = physics.inertia,
                 .full_curvature = true});
    const auto product = [&](double kx, double ky, double phase, int x, int y) {
        return mean_sine(kx, phase, x * cell, (x + 1) * cell) *
               mean_sine(ky, 0.4, y * cell, (y + 1) * cell);
    };
    bench.set_support([&](int x, int y) { return 0.2 + 0.2 * product(k, 2 * k, 1.0, x, y); });
    bench.fill([&](int x, int y) {
        return 1 + 0.4 * product(k, k, 0, x, y) + 0.2 * product(2 * k, k, 2.0, x, y);
    });
    const double limit = std::min(0.45 * bench.solver->stable_step_s(1.6), 0.1 * cell);
    bench.run(kSeconds / std::ceil(kSeconds / limit), kSeconds);
    std::vector<double> h;
    for (int y = 0; y < n; ++y)
        for (int x = 0; x < n; ++x)
            h.push_back(bench.h(x, y));
    return h;
}

/// Mean difference of n x n cells from the means of (2n) x (2n) cells.
double difference(const std::vector<double>& coarse, const std::vector<double>& fine, int n) {
    double sum = 0;
    for (int y = 0; y < n; ++y)
        for (int x = 0; x < n; ++x) {
            const double* corner = &fine[(2 * y) * 2 * n + 2 * x];
            const double mean = (corner[0] + corner[1] + corner[2 * n] + corner[2 * n + 1]) / 4;
            sum += std::abs(coarse[y * n + x] - mean) / (n * n);
        }
    return sum;
}

class SmoothWaves : public testing::TestWithParam<Physics> {};

TEST_P(SmoothWaves, ConvergeAtSecondOrder) {
    std::vector<double> coarse = waves(GetParam(), 16);
    double previous = 0;
    for (const int n : {16, 32, 64}) {
        const std::vector<double> fine = waves(GetParam(), 2 * n);
        const double error = difference(coarse, fine, n);
        if (previous > 0) {
            // 1.4 is demanded; 1.87 to 2.03 were reached, and 1.8 one grid finer: advection of momentum
            // and time are of first order, the flow that they disturb is slow.
            EXPECT_GT(std::log2(previous / error), 1.7) << n;
        }
        previous = error;
        coarse = fine;
    }
}
INSTANTIATE_TEST_SUITE_P(Physics, SmoothWaves,
                         testing::Values(Physics{"Creeping"},
                                         Physics{.name = "Inertial", .inertia = true},
                                         Physics{.name = "Yielding", .yield = 0.05}),
                         [](const auto& test) { return std::string(test.param.name); });

}  // namespace
}  // namespace pastoso::film::test
