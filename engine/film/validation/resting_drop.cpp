#include "core/units.hpp"
#include "film/validation/bench.hpp"
#include "film/validation/cap.hpp"
#include "film/validation/contact_lines.hpp"
#include "film/validation/outline.hpp"

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
            .solver = {.scheme = run.scheme},
            .watch = run.watch};
}

Outcome rest(const Run& run) {
    const Cap exact = Cap::of_slope(kBase_mm, std::tan(core::radians(kAdvancing_deg)));
    Bench bench(setup_of(run));
    const Cap start = Cap::of_volume(kStartBase_mm, exact.volume_mm3());
    fill_round(bench, [&](double r) { return start.h(r); });
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
    outcome.measured = radial_profile(bench);
    for (const PlotPoint& point : outcome.measured)
        outcome.exact.push_back({point.x, exact.h(point.x)});
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
