#include "film/cell/wet_media.hpp"
#include "film/validation/flows.hpp"
#include "film/validation/laws.hpp"
#include "film/validation/plane.hpp"

#include <cmath>

namespace pastoso::film::validation {
namespace {

constexpr double kGravity = 1000.0, kViscosity = 5.0;  // mm/s2, mm2/s
constexpr double kThickness_mm = 0.3, kPeriod_mm = 48.0;
constexpr double kStrong = 50.0, kWeak = 10.0;  // mm3/s2
constexpr double kFirst_s = 1.0, kLast_s = 4.0;

Setup film_of(const Run& run, double tension) {
    return {.gravity = kGravity,
            .viscosity = kViscosity,
            .tension = tension,
            .inertia = false,
            .lateral = false,
            .solver = {.scheme = run.scheme},
            .watch = run.watch};
}

/// Of the weaker part, by the mean share that cells hold of it.
double half_width_mm(const Plane& plane, const Bench& bench) {
    double sum = 0.0;
    for (int y = 0; y < plane.height(); ++y)
        for (int x = 0; x < plane.width(); ++x)
            sum += mixed_number(bench.state, bench.state.shape.tile_at(x, y),
                                grid::Shape::cell_in_tile(x, y), &FilmNumbers::surface_tension_N_m);
    const double mean = sum / (plane.width() * plane.height());
    const double strong = medium_of({.tension = kStrong}).surface_tension_N_m;
    const double weak = medium_of({.tension = kWeak}).surface_tension_N_m;
    return 0.5 * plane.period_mm() * (strong - mean) / (strong - weak);
}

Outcome spread(const Run& run) {
    const Plane plane(kPeriod_mm, run.angle_deg, run.cell_mm);
    Bench bench(plane.placed(film_of(run, kStrong)));
    plane.fill(bench, [](double) { return kThickness_mm; });
    const double centre = 0.5 * plane.period_mm(), reach = 0.25 * plane.period_mm();
    const auto is_weak = [&](double along) { return std::abs(along - centre) < reach ? 1.0 : 0.0; };
    bench.mix_in(medium_of(film_of(run, kWeak)),
                 [&](int x, int y) { return plane.mean(is_weak, x, y); });
    const double rate = TensionFront{.gravity = kGravity,
                                     .tension_step = kStrong - kWeak,
                                     .viscosity = kViscosity,
                                     .h = kThickness_mm}
                            .rate();
    const double start_mm = half_width_mm(plane, bench);
    Outcome outcome;
    outcome.measured = outcome.exact = {{0.0, 0.0}};
    double first_mm = 0.0;
    while (bench.passed_s < kLast_s - 1e-9) {
        bench.pass(0.25);
        const double way_mm = half_width_mm(plane, bench) - start_mm;
        if (std::abs(bench.passed_s - kFirst_s) < 1e-9) first_mm = way_mm;
        outcome.measured.push_back({bench.passed_s, way_mm});
        outcome.exact.push_back({bench.passed_s, rate * std::sqrt(bench.passed_s)});
    }
    const double measured =
        (outcome.measured.back().y - first_mm) / (std::sqrt(kLast_s) - std::sqrt(kFirst_s));
    outcome.figures.push_back({"way per root of time [mm/s^(1/2)]", measured, rate});
    return outcome;
}

}  // namespace

Case tension_front() {
    return {.name = "tension-front",
            .law =
                "a half film of lower tension goes out as t^(1/2), g (h2^2 - h1^2) = 3 d(sigma)/rho "
                "across its front",
            .source = "Oron, Davis and Bankoff, Rev. Mod. Phys. 69 (1997)",
            .cells_mm = {0.25, 0.125, 0.0625},
            .angles_deg = {0.0, 27.0, 45.0},
            .x_axis = "time [s]",
            .y_axis = "way of the front [mm]",
            .outcome = spread,
            .is_long = [](const Run& run) {
                const bool turned = run.angle_deg > 0.0;
                if (run.scheme == Scheme::Explicit) return turned || run.cell_mm < 0.1;
                return turned && run.cell_mm < 0.2;
            }};
}

}  // namespace pastoso::film::validation
