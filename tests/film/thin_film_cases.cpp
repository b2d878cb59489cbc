#include "film/thin_film_cases.hpp"

#include "film/validation/laws.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace pastoso::film::test {
namespace {

using std::numbers::pi;

double ripple_amplitude(const Bench& bench) {
    const int n = bench.setup.width;
    double cosine = 0, sine = 0;
    for (int x = 0; x < n; ++x) {
        cosine += bench.h(x, 1) * std::cos(2 * pi * (x + 0.5) / n);
        sine += bench.h(x, 1) * std::sin(2 * pi * (x + 0.5) / n);
    }
    return std::hypot(cosine, sine) * 2 / n;
}

constexpr validation::SlopeCurrent kSlopeCurrent{.area = 20, .force = 30, .viscosity = 30};
constexpr validation::RoundCurrent kRoundCurrent{.volume = 1500, .gravity = 10, .viscosity = 1};

SlopeCurrent look_at_slope(const Bench& bench, double t) {
    const int n = bench.setup.width;
    const double cell = bench.setup.cell_mm;
    int last = 0;
    for (int x = 0; x < n; ++x)
        if (bench.h(x, 1) > bench.h(last, 1)) last = x;
    const double half = bench.h(last, 1) / 2;
    while (bench.h(last + 1, 1) >= half)
        ++last;
    const double here = bench.h(last, 1), next = bench.h(last + 1, 1);
    SlopeCurrent current;
    current.front = (last + 0.5 + (here - half) / (here - next)) * cell;
    double area = 0;
    for (int x = 0; x < n; ++x) {
        const double exact = kSlopeCurrent.mean(x * cell, (x + 1) * cell, t);
        current.l1_error += std::abs(bench.h(x, 1) - exact);
        area += exact;
    }
    current.l1_error /= area;
    return current;
}

SpreadDrop look_at_drop(const Bench& bench, double t) {
    const int n = bench.setup.width;
    const double middle = bench.h(n / 2, n / 2);
    int covered = 0;
    for (int y = 0; y < n; ++y)
        for (int x = 0; x < n; ++x)
            covered += bench.h(x, y) > 0.02 * middle ? 1 : 0;
    return {t, std::sqrt(covered / pi) * bench.setup.cell_mm, middle};
}

}  // namespace

double ripple_decay_rate(double gravity, double tension, int n) {
    const double k = 2 * pi / n, viscosity = 10;
    const double rate = validation::ripple_rate(gravity, tension, 1.0, k, viscosity);
    Bench bench({.width = n,
                 .height = 4,
                 .gravity = gravity,
                 .viscosity = viscosity,
                 .tension = tension,
                 .inertia = false,
                 .lateral = false});
    bench.fill([k](int x, int) { return 1 + 0.05 * std::cos(k * (x + 0.5)); });
    const double dt = std::min(0.5 * bench.solver->stable_step_s(1.0), 0.02 / rate);
    const double seconds = std::ceil(1 / rate / dt) * dt;
    const double before = ripple_amplitude(bench);
    bench.run(dt, seconds);
    return std::log(before / ripple_amplitude(bench)) / seconds;
}

std::vector<SlopeCurrent> slope_current(double cell, const std::vector<double>& times) {
    Bench bench({.width = static_cast<int>(160 / cell),
                 .height = 4,
                 .cell_mm = cell,
                 .force_x = kSlopeCurrent.force,
                 .viscosity = kSlopeCurrent.viscosity,
                 .edge_x = Edge::Wall,
                 .inertia = false,
                 .lateral = false});
    double t = 5.0;
    bench.fill([&](int x, int) { return kSlopeCurrent.mean(x * cell, (x + 1) * cell, t); });
    std::vector<SlopeCurrent> results;
    for (const double wanted : times) {
        bench.run(0.05 * cell, wanted - t);
        t = wanted;
        results.push_back(look_at_slope(bench, t));
    }
    return results;
}

std::vector<SpreadDrop> axisymmetric_current(double cell, const std::vector<double>& times) {
    const int n = static_cast<int>(96 / cell);
    Bench bench(
        {.width = n, .height = n, .cell_mm = cell, .gravity = 10, .inertia = false, .lateral = false});
    bench.fill([&](int x, int y) {
        double mean = 0;
        for (int sample = 0; sample < 16; ++sample)
            mean += kRoundCurrent.h(std::hypot((x + (sample % 4 + 0.5) / 4) * cell - 48,
                                               (y + (sample / 4 + 0.5) / 4) * cell - 48),
                                    1.0) /
                    16;
        return mean;
    });
    const double dt = 0.5 * bench.solver->stable_step_s(kRoundCurrent.height(1.0));
    double t = 1.0;
    std::vector<SpreadDrop> results;
    for (const double wanted : times) {
        const double steps = std::max(0.0, std::round((wanted - t) / dt));
        bench.run(dt, steps * dt);
        t += steps * dt;
        results.push_back(look_at_drop(bench, t));
    }
    return results;
}

Drip drip(double angle_deg, double alpha_min, double alpha_max, const SolverOptions& options) {
    const double angle = angle_deg * pi / 180;
    const double cosine = std::cos(angle), sine = std::sin(angle);
    const int n = 160;
    Bench bench({.width = n,
                 .height = n,
                 .gravity = 1,
                 .force_x = 0.6 * cosine,
                 .force_y = 0.6 * sine,
                 .tension = 3,
                 .alpha_min = alpha_min,
                 .alpha_max = alpha_max,
                 .tan_advancing = 0.5,
                 .tan_receding = 0.25,
                 .slip_cells = 0.2,
                 .solver = options});
    const double start_x = 80 - 35 * cosine, start_y = 80 - 35 * sine;
    bench.fill([&](int x, int y) {
        const double r = std::hypot(x + 0.5 - start_x, y + 0.5 - start_y) / 14;
        return r < 1 ? 4 * (1 - r * r) : 0.0;
    });
    bench.run(0.04, 80.0);
    Drip result;
    for (int y = 0; y < n; ++y)
        for (int x = 0; x < n; ++x) {
            const double dx = x + 0.5 - start_x, dy = y + 0.5 - start_y;
            const double along = dx * cosine + dy * sine, across = dy * cosine - dx * sine;
            if (bench.h(x, y) > 0.3) {
                result.tip = std::max(result.tip, along);
                result.half_width = std::max(result.half_width, std::abs(across));
            }
            result.centroid += along * bench.h(x, y);
        }
    result.centroid /= bench.volume();
    return result;
}

Cap sessile_cap(double cell, double slope, bool full_curvature, double exact_height, double seconds) {
    constexpr double kRadius = 10, kStartRadius = 7;
    const double volume =
        full_curvature ? pi * exact_height / 6 * (3 * kRadius * kRadius + exact_height * exact_height)
                       : pi * slope * kRadius * kRadius * kRadius / 4;
    const int n = static_cast<int>(32 / cell);
    Bench bench({.width = n,
                 .height = n,
                 .cell_mm = cell,
                 .tension = 10,
                 .tan_advancing = slope,
                 .tan_receding = slope,
                 .slip_cells = 0.2,
                 .full_curvature = full_curvature});
    const double start_height = 2 * volume / (pi * kStartRadius * kStartRadius);
    bench.fill([&](int x, int y) {
        const double r = std::hypot((x + 0.5) * cell - 16, (y + 0.5) * cell - 16) / kStartRadius;
        return r < 1 ? start_height * (1 - r * r) : 0.0;
    });
    bench.run(0.4 * bench.solver->stable_step_s(start_height), seconds);
    double covered = 0;
    for (int y = 0; y < n; ++y)
        for (int x = 0; x < n; ++x)
            covered += std::min(1.0, std::sqrt(bench.h(x, y) * 2 / (cell * slope)));
    return {std::sqrt(covered * cell * cell / pi), bench.max_h()};
}

double terminal_velocity(const Scene& scene, double thickness, double dt_s, double seconds) {
    Bench bench(scene);
    bench.fill([thickness](int, int) { return thickness; });
    bench.run(dt_s, seconds);
    return bench.u(3, 1);
}

double arrested_height(double cell) {
    Bench bench({.width = static_cast<int>(100 / cell),
                 .height = 2,
                 .cell_mm = cell,
                 .gravity = 10,
                 .viscosity = 10,
                 .yield = 1,
                 .edge_x = Edge::Wall,
                 .inertia = false,
                 .lateral = false});
    bench.fill([cell](int x, int) { return (x + 0.5) * cell < 5 ? 6.0 : 0.0; });
    const double dt = 0.4 * bench.solver->stable_step_s(6.0);
    bench.run(dt, std::min(1200.0, 60000 * dt));
    return bench.h(0, 1);
}

double slope_deposit(double cell) {
    const int n = static_cast<int>(240 / cell);
    Bench bench({.width = n,
                 .height = 2,
                 .cell_mm = cell,
                 .gravity = 1,
                 .force_x = 2,
                 .viscosity = 5,
                 .yield = 1,
                 .edge_x = Edge::Wall,
                 .inertia = false,
                 .lateral = false});
    const auto place = [cell](int x) { return (x + 0.5) * cell; };
    bench.fill([&](int x, int) { return place(x) > 4 && place(x) < 24 ? 2.5 : 0.0; });
    const double dt =
        std::min(0.4 * bench.solver->stable_step_s(3.0), 0.2 * cell / (2 * 9 / 15.0 * 0.5));
    bench.run(dt, 1500.0);
    double sum = 0;
    int count = 0;
    for (int x = 0; x < n; ++x)
        if (place(x) > 30 && place(x) < 60) {
            sum += bench.h(x, 1);
            ++count;
        }
    return sum / count;
}

std::vector<double> levelled_waves(int n) {
    constexpr double kLength = 64, kSeconds = 12;
    const double cell = kLength / n;
    Bench bench({.width = n,
                 .height = 1,
                 .cell_mm = cell,
                 .gravity = 1,
                 .force_x = 0.3,
                 .tension = 0.5,
                 .inertia = false,
                 .lateral = false});
    const auto integral = [](double x) {
        return x - 0.5 * kLength / (2 * pi) * std::cos(2 * pi * x / kLength) +
               0.25 * kLength / (4 * pi) * std::sin(4 * pi * x / kLength);
    };
    bench.fill([&](int x, int) { return (integral((x + 1) * cell) - integral(x * cell)) / cell; });
    const double limit = std::min(0.45 * bench.solver->stable_step_s(1.8), 0.1 * cell);
    bench.run(kSeconds / std::ceil(kSeconds / limit), kSeconds);
    std::vector<double> h(n);
    for (int x = 0; x < n; ++x)
        h[x] = bench.h(x, 0);
    return h;
}

}  // namespace pastoso::film::test
