// What a yield stress holds.
#include "core/units.hpp"
#include "film/validation/flows.hpp"
#include "film/validation/laws.hpp"
#include "film/validation/plane.hpp"

#include <cmath>

namespace pastoso::film::validation {
namespace {

Outcome slump(const Run& run) {
    constexpr YieldedHeap kHeap{.half_area = 10.0, .yield = 5000.0, .gravity = 9800.0};
    constexpr double kStartHalf_mm = 2.5, kLongest_s = 20.0;
    const Plane plane(20.0, run.angle_deg, run.cell_mm);
    Bench bench(plane.placed({.gravity = kHeap.gravity,
                              .viscosity = 300.0,
                              .yield = kHeap.yield,
                              .inertia = false,
                              .lateral = false,
                              .sleeping = true,
                              .solver = {.scheme = run.scheme},
                              .watch = run.watch}));
    const double middle = 0.5 * plane.period_mm();
    plane.fill(bench, [&](double s) {
        return std::abs(s - middle) < kStartHalf_mm ? kHeap.half_area / kStartHalf_mm : 0.0;
    });
    while (bench.solver->awake_tile_count() > 0 && bench.passed_s < kLongest_s)
        bench.pass(0.5);
    const auto exact = [&](double s) { return kHeap.h(std::abs(s - middle)); };
    Outcome outcome;
    outcome.figures = {{"height [mm]", bench.max_h(), kHeap.height()},
                       {"profile, mean difference [-]", plane.l1_error(bench, exact), 0.0}};
    outcome.measured = plane.profile(bench);
    for (const PlotPoint& point : outcome.measured)
        outcome.exact.push_back({point.x, exact(point.x)});
    return outcome;
}

Outcome leave_a_tail(const Run& run) {
    constexpr double kForce = 5000.0, kGravity = 500.0, kYield = 2500.0, kViscosity = 500.0;
    constexpr double kFoot_mm = 1.0, kLength_mm = 4.0, kThickness_mm = 2.5, kSeconds = 16.0;
    constexpr double kFrom_mm = 6.0, kTo_mm = 12.0;
    const Plane plane(24.0, run.angle_deg, run.cell_mm);
    Bench bench(plane.placed({.gravity = kGravity,
                              .viscosity = kViscosity,
                              .yield = kYield,
                              .inertia = false,
                              .lateral = false,
                              .solver = {.scheme = run.scheme},
                              .watch = run.watch},
                             kForce));
    plane.fill(bench, [&](double s) {
        return s > kFoot_mm && s < kFoot_mm + kLength_mm ? kThickness_mm : 0.0;
    });
    bench.pass(kSeconds);
    const auto exact = [&](double s) {
        return yielded_tail(kForce, kYield, kViscosity, s - kFoot_mm, kSeconds);
    };
    Outcome outcome;
    double measured_mean = 0.0, exact_mean = 0.0, strips = 0.0;
    for (const PlotPoint& point : plane.profile(bench)) {
        outcome.measured.push_back(point);
        if (point.x > kFoot_mm && point.x < kTo_mm) outcome.exact.push_back({point.x, exact(point.x)});
        if (point.x < kFrom_mm || point.x > kTo_mm) continue;
        measured_mean += point.y;
        exact_mean += exact(point.x);
        strips += 1.0;
    }
    outcome.figures.push_back({"mean thickness [mm]", measured_mean / strips, exact_mean / strips});
    return outcome;
}

struct Marks {
    double kept;
    Curve profile;
};

/// What is left of brush marks of 5 % on half a millimetre of paint. Where whole cells allow another
/// wavelength only, the yield stress follows the stress of the marks, which goes by its third power.
Marks marks_after_levelling(const Run& run) {
    constexpr double kThickness_mm = 0.5, kShare = 0.05, kWavelength_mm = 3.0, kSeconds = 1.0;
    const Plane plane(kWavelength_mm, run.angle_deg, run.cell_mm);
    const double shorter = kWavelength_mm / plane.period_mm();
    Bench bench(plane.placed({.viscosity = 300.0,
                              .tension = 25000.0,
                              .yield = 1200.0 * shorter * shorter * shorter,
                              .solver = {.scheme = run.scheme},
                              .watch = run.watch}));
    const double k = 2.0 * core::kPi / plane.period_mm();
    plane.fill(bench, [&](double s) { return kThickness_mm * (1.0 + kShare * std::cos(k * s)); });
    bench.pass(kSeconds);
    const double cosine = plane.integral(bench, [&](double s, double h) { return h * std::cos(k * s); });
    return {cosine * 2.0 / plane.period_mm() / (kThickness_mm * kShare),
            plane.profile(bench, kThickness_mm)};
}

Outcome keep_marks(const Run& run) {
    const Run along{Scheme::Explicit, run.cell_mm, 0.0, run.watch};
    const Marks turned = marks_after_levelling(run), straight = marks_after_levelling(along);
    return {.figures = {{"amplitude kept [-]", turned.kept, straight.kept}},
            .measured = turned.profile,
            .exact = straight.profile};
}

}  // namespace

Case yielded_heap() {
    return {.name = "yielded-heap",
            .law = "a slump stops as h^2 = 2 tau_y/(rho g) (x_N - x)",
            .source = "Nye, Proc. R. Soc. A 207 (1951)",
            .cells_mm = {0.4, 0.2, 0.1},
            .angles_deg = {0.0, 27.0, 45.0},
            .x_axis = "place [mm]",
            .y_axis = "thickness [mm]",
            .outcome = slump,
            .is_long = [](const Run& run) {
                return run.scheme == Scheme::Explicit && run.cell_mm < 0.2 && run.angle_deg > 0.0;
            }};
}

Case yielded_slope() {
    return {.name = "yielded-slope",
            .law = "behind a current on a slope the film thins as h (h - tau_y/(rho F)) = x nu/(F t)",
            .source = "Liu and Mei, J. Fluid Mech. 207 (1989)",
            .cells_mm = {0.8, 0.4, 0.2},
            .angles_deg = {0.0, 27.0, 45.0},
            .x_axis = "way [mm]",
            .y_axis = "thickness [mm]",
            .outcome = leave_a_tail};
}

Case kept_marks() {
    return {
        .name = "kept-marks",
        .law =
            "a yield stress keeps the same brush marks at every angle, in large steps as in explicit "
            "ones",
        .source = "symmetry; the explicit scheme along an axis",
        .cells_mm = {0.25, 0.125, 0.0625},
        .angles_deg = {0.0, 27.0, 45.0},
        .x_axis = "place [mm]",
        .y_axis = "height above the mean [mm]",
        .outcome = keep_marks,
        .is_long = [](const Run& run) { return run.scheme == Scheme::Explicit && run.cell_mm < 0.1; }};
}

}  // namespace pastoso::film::validation
