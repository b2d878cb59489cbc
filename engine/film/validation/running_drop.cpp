#include "core/units.hpp"
#include "film/validation/bench.hpp"
#include "film/validation/flows.hpp"
#include "film/validation/laws.hpp"

#include <array>
#include <cmath>

namespace pastoso::film::validation {
namespace {

constexpr double kSide_mm = 24.0, kStart_mm = 10.0, kRadius_mm = 5.0, kHeight_mm = 1.0;
constexpr double kForce = 8000.0;
constexpr int kTicks = 20;

struct NamedPaint {
    const char* name;
    PlasticPaint paint;
};
constexpr std::array<NamedPaint, 4> kPaints = {
    {{"n 1", {.consistency = 100.0}},
     {"n 0.6", {.consistency = 500.0, .flow_index = 0.6}},
     {"n 0.35", {.consistency = 1200.0, .flow_index = 0.35}},
     {"n 0.6, 1.7 Pa", {.consistency = 600.0, .yield = 1700.0, .flow_index = 0.6}}}};

/// How far the middle of a drop has come on a canvas tilted towards the run's angle, tick by tick, mm.
Curve way_of(const PlasticPaint& paint, const Run& run) {
    const int side = static_cast<int>(std::lround(kSide_mm / run.cell_mm));
    const double down_x = std::cos(core::radians(run.angle_deg));
    const double down_y = std::sin(core::radians(run.angle_deg));
    Bench bench({.width = side,
                 .height = side,
                 .cell_mm = run.cell_mm,
                 .gravity = 5000,
                 .force_x = kForce * down_x,
                 .force_y = kForce * down_y,
                 .viscosity = paint.consistency,
                 .tension = 25000,
                 .yield = paint.yield,
                 .tan_advancing = 0.5,
                 .tan_receding = 0.2,
                 .slip_cells = 0.2,
                 .flow_index = paint.flow_index,
                 .full_curvature = true,
                 .sleeping = true,
                 .solver = {.scheme = run.scheme},
                 .watch = run.watch});
    bench.fill([&](int x, int y) {
        const double r =
            std::hypot((x + 0.5) * run.cell_mm - kStart_mm, (y + 0.5) * run.cell_mm - kStart_mm) /
            kRadius_mm;
        return r < 1.0 ? kHeight_mm * (1.0 - r * r) : 0.0;
    });
    const auto middle_mm = [&] {
        double along = 0.0;
        for (int y = 0; y < side; ++y)
            for (int x = 0; x < side; ++x)
                along += bench.h(x, y) * (x * down_x + y * down_y);
        return along / bench.volume() * run.cell_mm;
    };
    const double start_mm = middle_mm();
    Curve way = {{0.0, 0.0}};
    for (int tick = 1; tick <= kTicks; ++tick) {
        bench.pass(1.0 / 60.0);
        way.push_back({tick / 60.0, middle_mm() - start_mm});
    }
    return way;
}

/// The explicit scheme along an axis is what all others are held against.
Outcome run_down(const Run& run) {
    const Run reference{Scheme::Explicit, run.cell_mm, 0.0, run.watch};
    Outcome outcome;
    for (const NamedPaint& named : kPaints) {
        outcome.measured = way_of(named.paint, run);
        outcome.exact = way_of(named.paint, reference);
        outcome.figures.push_back({std::string("way, ") + named.name + " [mm]",
                                   outcome.measured.back().y, outcome.exact.back().y});
    }
    return outcome;
}

}  // namespace

Case running_drop() {
    return {.name = "running-drop",
            .law = "a drop runs down as far in every direction, and in large steps as in explicit ones",
            .source = "symmetry; the explicit scheme along an axis",
            .cells_mm = {0.5, 0.375, 0.25},
            .angles_deg = {0.0, 27.0, 45.0},
            .x_axis = "time [s]",
            .y_axis = "way [mm]",
            .outcome = run_down};
}

}  // namespace pastoso::film::validation
