#include "core/units.hpp"
#include "film/validation/bench.hpp"
#include "film/validation/cap.hpp"
#include "film/validation/contact_lines.hpp"

#include <cmath>

namespace pastoso::film::validation {
namespace {

constexpr double kAdvancing_deg = 27.0, kReceding_deg = 10.0;
constexpr double kBase_mm = 2.0, kStartBase_mm = 1.5, kSide_mm = 5.6;
constexpr double kLongest_s = 12.0;
/// Where the outline is taken, of the exact height: the foot itself lies somewhere within a cell.
constexpr double kOutline = 0.1;

Setup setup_of(const Run& run) {
    const int side = static_cast<int>(std::lround(kSide_mm / run.cell_mm));
    return {.width = side,
            .height = side,
            .cell_mm = run.cell_mm,
            .viscosity = 100,
            .tension = 25000,
            .tan_advancing = std::tan(core::radians(kAdvancing_deg)),
            .tan_receding = std::tan(core::radians(kReceding_deg)),
            .slip_cells = 0.2,
            .full_curvature = true,
            .sleeping = true,
            .solver = {.scheme = run.scheme}};
}

void lay_down(const Cap& start, Bench& bench) {
    const double middle = 0.5 * bench.setup.width;
    bench.fill([&](int x, int y) {
        double sum = 0.0;
        for (int sample = 0; sample < 64; ++sample)
            sum += start.h(
                std::hypot(x + (sample % 8 + 0.5) / 8 - middle, y + (sample / 8 + 0.5) / 8 - middle) *
                bench.setup.cell_mm);
        return sum / 64;
    });
}

/// h between the centres of four cells.
double interpolated(const Bench& bench, double x_cells, double y_cells) {
    const int x = static_cast<int>(std::floor(x_cells - 0.5)),
              y = static_cast<int>(std::floor(y_cells - 0.5));
    const double fx = x_cells - 0.5 - x, fy = y_cells - 0.5 - y;
    return (1 - fy) * ((1 - fx) * bench.h(x, y) + fx * bench.h(x + 1, y)) +
           fy * ((1 - fx) * bench.h(x, y + 1) + fx * bench.h(x + 1, y + 1));
}

/// Where the drop has thinned to `h_mm` in a direction from its middle, mm.
double radius_towards(const Bench& bench, double angle_deg, double h_mm) {
    constexpr double kStep_cells = 0.01;
    const double middle = 0.5 * bench.setup.width;
    const double cosine = std::cos(core::radians(angle_deg)), sine = std::sin(core::radians(angle_deg));
    double r = 0.0;
    while (r < middle - 2.0 && interpolated(bench, middle + r * cosine, middle + r * sine) > h_mm)
        r += kStep_cells;
    return r * bench.setup.cell_mm;
}

Outcome rest(const Run& run) {
    const Cap exact = Cap::of_slope(kBase_mm, std::tan(core::radians(kAdvancing_deg)));
    Bench bench(setup_of(run));
    lay_down(Cap::of_volume(kStartBase_mm, exact.volume_mm3()), bench);
    while (bench.solver->awake_tile_count() > 0 && bench.passed_s < kLongest_s)
        bench.pass(0.1);
    const double outline_mm = kOutline * exact.height_mm, radius_mm = exact.radius_at(outline_mm);
    Outcome outcome;
    outcome.figures.push_back({"height [mm]", bench.max_h(), exact.height_mm});
    for (const double angle : {0.0, 27.0, 45.0})
        outcome.figures.push_back({.quantity = "radius [mm]",
                                   .measured = radius_towards(bench, angle, outline_mm),
                                   .exact = radius_mm,
                                   .angle_deg = angle});
    const double middle = 0.5 * bench.setup.width;
    for (double r = 0.0; r < 1.25 * kBase_mm; r += 0.25 * run.cell_mm) {
        outcome.measured.push_back({r, interpolated(bench, middle + r / run.cell_mm, middle)});
        outcome.exact.push_back({r, exact.h(r)});
    }
    return outcome;
}

}  // namespace

Case resting_drop() {
    return {
        .name = "resting-drop",
        .law = "a drop that spreads stops as the spherical cap of its advancing angle, 27 degrees",
        .source = "Laplace (1806), Young (1805)",
        .cells_mm = {0.25, 0.125, 0.0625},
        .angles_deg = {0.0},
        .x_axis = "distance from the middle [mm]",
        .y_axis = "thickness [mm]",
        .outcome = rest,
        .is_long = [](const Run& run) { return run.scheme == Scheme::Explicit && run.cell_mm < 0.1; }};
}

}  // namespace pastoso::film::validation
