// Level films that run down.
#include "core/units.hpp"
#include "film/validation/bench.hpp"
#include "film/validation/flows.hpp"
#include "film/validation/laws.hpp"

#include <cmath>
#include <cstdio>

namespace pastoso::film::validation {
namespace {

constexpr double kForce = 9000.0;  // mm/s2
constexpr double kSeconds = 2.0;

/// Mean speed that a film of this thickness ends with, mm/s.
double final_speed(const Run& run, Setup setup, double h_mm) {
    setup.width = setup.height = 8;
    setup.cell_mm = run.cell_mm;
    setup.force_x = kForce * std::cos(core::radians(run.angle_deg));
    setup.force_y = kForce * std::sin(core::radians(run.angle_deg));
    setup.solver.scheme = run.scheme;
    setup.watch = run.watch;
    Bench bench(setup);
    bench.fill([h_mm](int, int) { return h_mm; });
    bench.pass(kSeconds);
    return std::hypot(bench.u(3, 3), bench.v(3, 3));
}

std::string quantity(const char* format, double value) {
    char text[64];
    std::snprintf(text, sizeof text, format, value);
    return text;
}

Outcome nusselt(const Run& run) {
    constexpr double kThickness_mm = 0.4, kViscosity = 1000.0;
    Outcome outcome;
    for (const double alpha : {0.5, 0.75, 1.0, 1.2}) {
        const Setup setup{.viscosity = kViscosity, .alpha_min = alpha, .alpha_max = alpha};
        const double measured = final_speed(run, setup, kThickness_mm);
        const double exact = nusselt_speed(kForce, kThickness_mm, kViscosity, alpha);
        if (alpha == 0.5 || alpha == 1.0)
            outcome.figures.push_back({quantity("speed, alpha %g [mm/s]", alpha), measured, exact});
        outcome.measured.push_back({alpha, measured});
        outcome.exact.push_back({alpha, exact});
    }
    return outcome;
}

Setup setup_of(const PlasticPaint& paint) {
    return {.viscosity = paint.consistency, .yield = paint.yield, .flow_index = paint.flow_index};
}

Outcome bingham(const Run& run) {
    constexpr PlasticPaint kPaint{.consistency = 500.0, .yield = 1800.0};
    Outcome outcome;
    for (const double h_mm : {0.199, 0.25, 0.3, 0.4, 0.5}) {
        const double measured = final_speed(run, setup_of(kPaint), h_mm);
        const double exact = plastic_speed(kPaint, kForce, h_mm);
        if (h_mm <= 0.25 || h_mm == 0.5)
            outcome.figures.push_back({quantity("speed, %g mm thick [mm/s]", h_mm), measured, exact});
        outcome.measured.push_back({h_mm, measured});
        outcome.exact.push_back({h_mm, exact});
    }
    return outcome;
}

Outcome herschel_bulkley(const Run& run) {
    constexpr double kThickness_mm = 0.4;
    Outcome outcome;
    for (const double n : {0.3, 0.45, 0.6, 0.8, 1.0}) {
        // As fast as a paint of 1000 mm2/s, whatever n.
        const PlasticPaint paint{
            .consistency = 1800 * std::pow(1.8, -n), .yield = 1800, .flow_index = n};
        const double measured = final_speed(run, setup_of(paint), kThickness_mm);
        const double exact = plastic_speed(paint, kForce, kThickness_mm);
        if (n == 0.3 || n == 0.6)
            outcome.figures.push_back({quantity("speed, n %g [mm/s]", n), measured, exact});
        outcome.measured.push_back({n, measured});
        outcome.exact.push_back({n, exact});
    }
    return outcome;
}

}  // namespace

Case nusselt_film() {
    return {.name = "nusselt-film",
            .law = "a film runs at F h^2 (3 alpha - 1) / (6 nu)",
            .source = "Nusselt (1916)",
            .cells_mm = {0.5, 0.25, 0.125},
            .angles_deg = {0.0, 27.0, 45.0},
            .x_axis = "alpha",
            .y_axis = "speed [mm/s]",
            .outcome = nusselt};
}

Case bingham_film() {
    return {.name = "bingham-film",
            .law = "F h^2/(3 nu) (1 - B)^2 (1 + B/2), B = tau_y/(rho F h); still for B > 1",
            .source = "Bingham (1922)",
            .cells_mm = {0.5, 0.25, 0.125},
            .angles_deg = {0.0, 27.0, 45.0},
            .x_axis = "thickness [mm]",
            .y_axis = "speed [mm/s]",
            .outcome = bingham};
}

Case herschel_bulkley_film() {
    return {
        .name = "herschel-bulkley-film",
        .law =
            "h g n/(n+1) e (1 - n/(2n+1) e), g = ((F h - tau_y/rho)/K)^(1/n), e = 1 - tau_y/(rho F h)",
        .source = "Herschel and Bulkley (1926)",
        .cells_mm = {0.5, 0.25, 0.125},
        .angles_deg = {0.0, 27.0, 45.0},
        .x_axis = "flow index n",
        .y_axis = "speed [mm/s]",
        .outcome = herschel_bulkley};
}

}  // namespace pastoso::film::validation
