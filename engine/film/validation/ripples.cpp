// Small waves on a film.
#include "core/units.hpp"
#include "film/validation/flows.hpp"
#include "film/validation/laws.hpp"
#include "film/validation/plane.hpp"

#include <cmath>
#include <complex>

namespace pastoso::film::validation {
namespace {

/// Amplitude and phase of the wave that fits once onto a plane's way, mm.
std::complex<double> wave_on(const Plane& plane, const Bench& bench) {
    const double k = 2.0 * core::kPi / plane.period_mm();
    const double cosine = plane.integral(bench, [&](double s, double h) { return h * std::cos(k * s); });
    const double sine = plane.integral(bench, [&](double s, double h) { return h * std::sin(k * s); });
    return std::complex(cosine, sine) * (2.0 / plane.period_mm());
}

void fill_wave(const Plane& plane, double h_mm, double share, Bench& bench) {
    const double k = 2.0 * core::kPi / plane.period_mm();
    plane.fill(bench, [&](double s) { return h_mm * (1.0 + share * std::cos(k * s)); });
}

struct Ripple {
    double gravity, tension, viscosity;
    double h_mm, wavelength_mm;
};

/// The rate over two decay times.
Outcome fade(const Ripple& ripple, const Run& run) {
    constexpr double kShare = 0.02, kDecays = 2.0;
    constexpr int kRows = 20;
    const Plane plane(ripple.wavelength_mm, run.angle_deg, run.cell_mm);
    Bench bench(plane.placed({.gravity = ripple.gravity,
                              .viscosity = ripple.viscosity,
                              .tension = ripple.tension,
                              .inertia = false,
                              .lateral = false,
                              .solver = {.scheme = run.scheme},
                              .watch = run.watch}));
    fill_wave(plane, ripple.h_mm, kShare, bench);
    const double exact = ripple_rate(ripple.gravity, ripple.tension, ripple.h_mm,
                                     2.0 * core::kPi / plane.period_mm(), ripple.viscosity);
    // Whole ticks, so that looking at the ripple cuts none.
    const double row_s = std::ceil(60.0 * kDecays / exact / kRows) / 60.0;
    const double start = std::abs(wave_on(plane, bench));
    Outcome outcome;
    outcome.measured = outcome.exact = {{0.0, 1.0}};
    for (int row = 1; row <= kRows; ++row) {
        bench.pass(row_s);
        outcome.measured.push_back({row * row_s * exact, std::abs(wave_on(plane, bench)) / start});
        outcome.exact.push_back({row * row_s * exact, std::exp(-row * row_s * exact)});
    }
    const double measured = -std::log(outcome.measured.back().y) / (kRows * row_s);
    outcome.figures.push_back({"rate [1/s]", measured, exact});
    return outcome;
}

Outcome fade_by_gravity(const Run& run) {
    return fade({.gravity = 9800, .tension = 0, .viscosity = 300, .h_mm = 0.5, .wavelength_mm = 8}, run);
}

Outcome fade_by_tension(const Run& run) {
    return fade({.gravity = 0, .tension = 25000, .viscosity = 3000, .h_mm = 0.5, .wavelength_mm = 4},
                run);
}

/// Half a wavelength's way of a wave on a film that runs down without tension and normal gravity.
Outcome run_on(const Run& run) {
    constexpr double kForce = 5000.0, kViscosity = 1000.0, kThickness_mm = 0.5, kShare = 0.01;
    const Plane plane(8.0, run.angle_deg, run.cell_mm);
    Bench bench(plane.placed({.viscosity = kViscosity,
                              .inertia = false,
                              .lateral = false,
                              .solver = {.scheme = run.scheme},
                              .watch = run.watch},
                             kForce));
    fill_wave(plane, kThickness_mm, kShare, bench);
    const std::complex<double> start = wave_on(plane, bench);
    const double speed = 3.0 * nusselt_speed(kForce, kThickness_mm, kViscosity);
    const double k = 2.0 * core::kPi / plane.period_mm();
    const double seconds = std::round(60.0 * 0.5 * plane.period_mm() / speed) / 60.0;
    // The phase is followed from half way to half way: it is known up to whole waves only.
    bench.pass(0.5 * seconds);
    const std::complex<double> middle = wave_on(plane, bench);
    bench.pass(seconds - bench.passed_s);
    const std::complex<double> end = wave_on(plane, bench);
    const double way_mm = (std::arg(middle / start) + std::arg(end / middle)) / k;
    Outcome outcome;
    outcome.figures = {{"amplitude kept [-]", std::abs(end) / std::abs(start), 1.0},
                       {"way [mm]", way_mm, speed * seconds}};
    outcome.measured = plane.profile(bench, kThickness_mm);
    for (const PlotPoint& point : outcome.measured)
        outcome.exact.push_back(
            {point.x, kThickness_mm * kShare * std::cos(k * (point.x - speed * seconds))});
    return outcome;
}

}  // namespace

Case gravity_ripple() {
    return {.name = "gravity-ripple",
            .law = "a ripple fades at the rate h^3 g k^2 / (3 nu)",
            .source = "Orchard, Appl. Sci. Res. A 11 (1962)",
            .cells_mm = {0.5, 0.25, 0.125},
            .angles_deg = {0.0, 27.0, 45.0},
            .x_axis = "time in decay times",
            .y_axis = "amplitude",
            .outcome = fade_by_gravity};
}

Case tension_ripple() {
    return {.name = "tension-ripple",
            .law = "a ripple fades at the rate h^3 sigma k^4 / (3 rho nu)",
            .source = "Orchard, Appl. Sci. Res. A 11 (1962)",
            .cells_mm = {0.25, 0.125, 0.0625},
            .angles_deg = {0.0, 27.0, 45.0},
            .x_axis = "time in decay times",
            .y_axis = "amplitude",
            .outcome = fade_by_tension};
}

Case running_wave() {
    return {.name = "running-wave",
            .law = "a long wave on a running film neither grows nor fades, and goes at F h^2 / nu",
            .source = "Kapitza (1948); Lighthill and Whitham (1955)",
            .cells_mm = {0.5, 0.25, 0.125},
            .angles_deg = {0.0, 27.0, 45.0},
            .x_axis = "way [mm]",
            .y_axis = "height above the mean [mm]",
            .outcome = run_on};
}

}  // namespace pastoso::film::validation
