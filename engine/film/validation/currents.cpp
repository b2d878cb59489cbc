// Currents that thin as they run and spread.
#include "core/units.hpp"
#include "film/validation/flows.hpp"
#include "film/validation/laws.hpp"
#include "film/validation/outline.hpp"
#include "film/validation/plane.hpp"

#include <cmath>

namespace pastoso::film::validation {
namespace {

/// Where the profile falls to half its peak, beyond the peak.
double front_of(const Curve& profile) {
    std::size_t thickest = 0;
    for (std::size_t i = 1; i < profile.size(); ++i)
        if (profile[i].y > profile[thickest].y) thickest = i;
    const double half = 0.5 * profile[thickest].y;
    for (std::size_t i = thickest + 1; i < profile.size(); ++i) {
        const PlotPoint before = profile[i - 1], after = profile[i];
        if (after.y < half)
            return before.x + (before.y - half) / (before.y - after.y) * (after.x - before.x);
    }
    return profile.back().x;
}

Outcome run_down(const Run& run) {
    constexpr SlopeCurrent kCurrent{.area = 10.0, .force = 9000.0, .viscosity = 3000.0};
    constexpr double kStart_s = 0.25, kEnd_s = 8.0;
    const Plane plane(24.0, run.angle_deg, run.cell_mm);
    Bench bench(plane.placed({.viscosity = kCurrent.viscosity,
                              .inertia = false,
                              .lateral = false,
                              .solver = {.scheme = run.scheme},
                              .watch = run.watch},
                             kCurrent.force));
    plane.fill(bench, [&](double s) { return kCurrent.h(s, kStart_s); });
    bench.pass(kEnd_s - kStart_s);
    Outcome outcome;
    outcome.measured = plane.profile(bench);
    const auto exact = [&](double s) { return kCurrent.h(s, kEnd_s); };
    for (const PlotPoint& point : outcome.measured)
        outcome.exact.push_back({point.x, exact(point.x)});
    outcome.figures = {{"front [mm]", front_of(outcome.measured), kCurrent.front(kEnd_s)},
                       {"profile, mean difference [-]", plane.l1_error(bench, exact), 0.0}};
    return outcome;
}

Outcome spread(const Run& run) {
    constexpr RoundCurrent kCurrent{.volume = 60.0, .gravity = 9800.0, .viscosity = 3000.0};
    constexpr double kStart_s = 0.3, kEnd_s = 8.0, kOutline = 0.1;
    const int side = static_cast<int>(std::lround(13.6 / run.cell_mm));
    Bench bench({.width = side,
                 .height = side,
                 .cell_mm = run.cell_mm,
                 .gravity = kCurrent.gravity,
                 .viscosity = kCurrent.viscosity,
                 .inertia = false,
                 .lateral = false,
                 .solver = {.scheme = run.scheme},
                 .watch = run.watch});
    fill_round(bench, [&](double r) { return kCurrent.h(r, kStart_s); });
    bench.pass(kEnd_s - kStart_s);
    const double height_mm = kCurrent.height(kEnd_s);
    const double outline_mm = kCurrent.radius(kEnd_s) * std::sqrt(1 - kOutline * kOutline * kOutline);
    Outcome outcome;
    outcome.figures.push_back({"height [mm]", bench.max_h(), height_mm});
    for (const double angle : {0.0, 27.0, 45.0})
        outcome.figures.push_back({.quantity = "radius [mm]",
                                   .measured = radius_towards(bench, angle, kOutline * height_mm),
                                   .exact = outline_mm,
                                   .angle_deg = angle});
    outcome.measured = radial_profile(bench);
    for (const PlotPoint& point : outcome.measured)
        outcome.exact.push_back({point.x, kCurrent.h(point.x, kEnd_s)});
    return outcome;
}

}  // namespace

Case slope_current() {
    return {.name = "slope-current",
            .law = "h = (nu x / (F t))^(1/2) up to the front at (9 A^2 F t / (4 nu))^(1/3)",
            .source = "Huppert, Nature 300 (1982)",
            .cells_mm = {0.4, 0.2, 0.1},
            .angles_deg = {0.0, 27.0, 45.0},
            .x_axis = "way [mm]",
            .y_axis = "thickness [mm]",
            .outcome = run_down};
}

Case round_current() {
    return {.name = "round-current",
            .law =
                "a heap spreads as R = 0.894 (g V^3 t / (3 nu))^(1/8), h = 4 V/(3 pi R^2) (1 - "
                "r^2/R^2)^(1/3)",
            .source = "Huppert, J. Fluid Mech. 121 (1982)",
            .cells_mm = {0.4, 0.2, 0.1},
            .angles_deg = {0.0},
            .x_axis = "distance from the middle [mm]",
            .y_axis = "thickness [mm]",
            .outcome = spread};
}

}  // namespace pastoso::film::validation
