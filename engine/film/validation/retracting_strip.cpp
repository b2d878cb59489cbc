#include "core/units.hpp"
#include "film/validation/contact_lines.hpp"
#include "film/validation/laws.hpp"
#include "film/validation/plane.hpp"

#include <algorithm>
#include <cmath>

namespace pastoso::film::validation {
namespace {

constexpr double kTension = 25000.0, kViscosity = 50.0;  // mm3/s2, mm2/s
constexpr double kHalfWidth_mm = 5.0, kPeriod_mm = 14.0;
constexpr double kStartSlope = 0.15, kReceding = 0.6, kAdvancing = 0.9;
constexpr double kSlip_cells = 0.2;
constexpr double kSection_mm2 = 2.0 / 3.0 * kHalfWidth_mm * kHalfWidth_mm * kStartSlope;
/// In which widths are measured: nu L / (sigma/rho).
constexpr double kUnit_s = kViscosity * kHalfWidth_mm / kTension;
constexpr double kPatience = 4.0;

RetractingStrip strip_in(double cell_mm) {
    return {.section = kSection_mm2,
            .receding = kReceding,
            .tension = kTension,
            .viscosity = kViscosity,
            .slip = kSlip_cells * cell_mm};
}

/// Nineteen twentieths of the way.
double wanted_half_width_mm(const RetractingStrip& strip) {
    return strip.last_half_width() + 0.05 * (kHalfWidth_mm - strip.last_half_width());
}

double half_width_at_start(double s) {
    return 0.5 * kStartSlope / kHalfWidth_mm * std::max(0.0, kHalfWidth_mm * kHalfWidth_mm - s * s);
}

/// Half-width over time, in units of kUnit_s.
Curve exact_course(const RetractingStrip& strip) {
    constexpr int kSteps = 2000;
    Curve course = {{0.0, kHalfWidth_mm}};
    const double step_mm = (kHalfWidth_mm - wanted_half_width_mm(strip)) / kSteps;
    for (int i = 0; i < kSteps; ++i) {
        const double middle_mm = kHalfWidth_mm - (i + 0.5) * step_mm;
        const double t = course.back().x + step_mm / strip.retreat_speed(middle_mm) / kUnit_s;
        course.push_back({t, kHalfWidth_mm - (i + 1) * step_mm});
    }
    return course;
}

/// That of a parabola of the same spread.
double half_width_mm(const Plane& plane, const Bench& bench) {
    const double centre = 0.5 * plane.period_mm();
    const double area = plane.integral(bench, [](double, double h) { return h; });
    const double spread =
        plane.integral(bench, [&](double s, double h) { return h * (s - centre) * (s - centre); });
    return std::sqrt(5.0 * spread / area);
}

Outcome draw_back(const Run& run) {
    const Plane plane(kPeriod_mm, run.angle_deg, run.cell_mm);
    Bench bench(plane.placed({.viscosity = kViscosity,
                              .tension = kTension,
                              .tan_advancing = kAdvancing,
                              .tan_receding = kReceding,
                              .slip_cells = kSlip_cells,
                              .sleeping = true,
                              .solver = {.scheme = run.scheme},
                              .watch = run.watch}));
    const double centre = 0.5 * plane.period_mm();
    plane.fill(bench, [&](double s) { return half_width_at_start(s - centre); });
    Outcome outcome;
    const RetractingStrip strip = strip_in(run.cell_mm);
    outcome.exact = exact_course(strip);
    outcome.measured = {{0.0, half_width_mm(plane, bench)}};
    const double exact = outcome.exact.back().x;
    while (outcome.measured.back().y > wanted_half_width_mm(strip) &&
           outcome.measured.back().x < kPatience * exact) {
        bench.pass(1.0 / 60.0);
        outcome.measured.push_back({bench.passed_s / kUnit_s, half_width_mm(plane, bench)});
    }
    const PlotPoint& end = outcome.measured.back();
    outcome.figures.push_back({.quantity = "time [nu L/sigma]",
                               .measured = end.x,
                               .exact = exact,
                               .at_least = end.y > wanted_half_width_mm(strip)});
    return outcome;
}

}  // namespace

Case retracting_strip() {
    return {.name = "retracting-strip",
            .law = "a strip flatter than its receding slope draws back by Cox and Voinov's law",
            .source = "Voinov (1976), Cox (1986); strip: Savva and Kalliadasis (2009)",
            .cells_mm = {0.4, 0.2, 0.1},
            .angles_deg = {0.0, 27.0, 45.0},
            .x_axis = "time [nu L/sigma]",
            .y_axis = "half-width [mm]",
            .outcome = draw_back,
            .is_long = [](const Run& run) {
                return run.scheme == Scheme::Explicit && run.cell_mm < 0.2 && run.angle_deg > 0.0;
            }};
}

}  // namespace pastoso::film::validation
