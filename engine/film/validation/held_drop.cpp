#include "core/units.hpp"
#include "film/validation/cap.hpp"
#include "film/validation/contact_lines.hpp"
#include "film/validation/plane.hpp"

#include <array>
#include <cmath>
#include <cstdio>

namespace pastoso::film::validation {
namespace {

constexpr double kTension = 25000.0, kViscosity = 50.0;  // mm3/s2, mm2/s
constexpr double kHalfBase_mm = 1.0, kPeriod_mm = 6.0;
constexpr double kLongest_s = 6.0;

struct Slopes {
    double advancing, receding;
};
constexpr std::array<Slopes, 3> kSlopes = {{{0.9, 0.7}, {0.5, 0.17}, {0.9, 0.35}}};

/// cos(theta_R) - cos(theta_A): the force in surface tensions.
double exact_force(const Slopes& slopes) {
    return std::cos(std::atan(slopes.receding)) - std::cos(std::atan(slopes.advancing));
}

/// Where the drop's middle lies on its periodic way, mm from the start.
double displacement_mm(const Plane& plane, const Bench& bench) {
    const double wave = 2.0 * core::kPi / plane.period_mm();
    const double centre = 0.5 * plane.period_mm();
    const double sine =
        plane.integral(bench, [&](double s, double h) { return h * std::sin(wave * (s - centre)); });
    const double cosine =
        plane.integral(bench, [&](double s, double h) { return h * std::cos(wave * (s - centre)); });
    return std::atan2(sine, cosine) / wave;
}

/// Whether a drop that starts between its two angles comes to rest under this force. One that runs goes
/// on for as far as it is wide, or still creeps in the end.
bool is_held(const Run& run, const Slopes& slopes, double force_in_tensions) {
    const Plane plane(kPeriod_mm, run.angle_deg, run.cell_mm);
    const Cap start = Cap::of_slope(kHalfBase_mm, 0.5 * (slopes.advancing + slopes.receding));
    Bench bench(plane.placed({.viscosity = kViscosity,
                              .tension = kTension,
                              .tan_advancing = slopes.advancing,
                              .tan_receding = slopes.receding,
                              .slip_cells = 0.2,
                              .full_curvature = true,
                              .sleeping = true,
                              .solver = {.scheme = run.scheme},
                              .watch = run.watch},
                             force_in_tensions * kTension / start.section_mm2()));
    const double centre = 0.5 * plane.period_mm();
    plane.fill(bench, [&](double s) { return start.h(std::abs(s - centre)); });
    double before_mm = 0.0;
    while (bench.passed_s < kLongest_s) {
        bench.pass(0.1);
        if (bench.solver->awake_tile_count() == 0) return true;
        const double now_mm = displacement_mm(plane, bench);
        if (now_mm > 1.5 * kHalfBase_mm || now_mm < 0.0) return false;
        if (bench.passed_s < 0.67 * kLongest_s) before_mm = now_mm;
    }
    return displacement_mm(plane, bench) - before_mm < 0.02 * kHalfBase_mm;
}

/// The largest force that holds, to 2 %, between a half and five times the exact one, in surface
/// tensions.
Figure critical_force(const Run& run, const Slopes& slopes) {
    char quantity[64];
    std::snprintf(quantity, sizeof quantity, "force, slopes %.2g and %.2g [sigma]", slopes.advancing,
                  slopes.receding);
    const double exact = exact_force(slopes), most = 5.0 * exact;
    double holds = 0.5 * exact, runs = most;
    for (int halving = 0; halving < 6; ++halving) {
        const double force = std::sqrt(holds * runs);
        (is_held(run, slopes, force) ? holds : runs) = force;
    }
    if (runs == most) return {quantity, holds, exact, true};
    return {quantity, std::sqrt(holds * runs), exact};
}

Outcome hold(const Run& run) {
    Outcome outcome;
    for (const Slopes& slopes : kSlopes) {
        outcome.figures.push_back(critical_force(run, slopes));
        const Figure& figure = outcome.figures.back();
        outcome.measured.push_back({figure.exact, figure.measured});
    }
    outcome.exact = {{0.0, 0.0}, {0.25, 0.25}};
    return outcome;
}

}  // namespace

Case held_drop() {
    return {.name = "held-drop",
            .law = "a planar drop on a slope holds rho F A = sigma (cos theta_R - cos theta_A)",
            .source = "Furmidge (1962); Dussan and Chow (1983)",
            .cells_mm = {0.2, 0.1, 0.05},
            .angles_deg = {0.0, 27.0, 45.0},
            .x_axis = "exact force [sigma]",
            .y_axis = "force that holds [sigma]",
            .outcome = hold,
            .is_long = [](const Run& run) {
                const bool is_explicit = run.scheme == Scheme::Explicit, turned = run.angle_deg > 0.0;
                return run.cell_mm < 0.1 ? is_explicit || turned
                                         : run.cell_mm < 0.2 && is_explicit && turned;
            }};
}

}  // namespace pastoso::film::validation
