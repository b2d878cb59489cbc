#include "film/film_bench.hpp"

#include "core/units.hpp"

#include <algorithm>
#include <cmath>

namespace pastoso::film::test {
namespace {

constexpr double kDensity_kg_m3 = 1000.0;

Medium medium_of(const Scene& scene) {
    Medium medium;
    medium.name = "test paint";
    medium.density_kg_m3 = kDensity_kg_m3;
    medium.viscosity_m2_s = scene.viscosity * 1e-6;
    medium.surface_tension_N_m = scene.tension * 1e-9 * kDensity_kg_m3;
    medium.yield_stress_Pa = scene.yield * 1e-6 * kDensity_kg_m3;
    medium.flow_index = scene.flow_index;
    medium.structure_share = scene.structure_share;
    medium.recovery_s = scene.recovery_s;
    medium.breakdown_strain = scene.breakdown_strain;
    medium.alpha_min = scene.alpha_min;
    medium.alpha_max = scene.alpha_max;
    medium.advancing_angle_deg = core::degrees(std::atan(scene.tan_advancing));
    medium.receding_angle_deg = core::degrees(std::atan(scene.tan_receding));
    medium.slip_cells = scene.slip_cells;
    return medium;
}

SolverOptions options_of(const Scene& scene) {
    SolverOptions options = scene.solver;
    options.edge_x = scene.edge_x;
    options.edge_y = scene.edge_y;
    options.inertia = scene.inertia;
    options.lateral_drag = scene.lateral;
    options.horizontal_tension = scene.horizontal_tension;
    options.full_curvature = scene.full_curvature;
    options.sleeping = scene.sleeping;
    return options;
}

}  // namespace

double blob(double x, double y, double centre_x, double centre_y, double radius, double height) {
    const double r = std::hypot(x + 0.5 - centre_x, y + 0.5 - centre_y) / radius;
    return r < 1 ? height * (1 - r * r) : 0.0;
}

Scene runny(int width, int height) {
    return {.width = width,
            .height = height,
            .gravity = 1,
            .force_x = 0.3,
            .force_y = 0.5,
            .tension = 3,
            .alpha_min = 0.5,
            .alpha_max = 1.2,
            .tan_advancing = 0.5,
            .tan_receding = 0.2,
            .slip_cells = 0.2};
}

std::string name_of(Edge edge) {
    switch (edge) {
        case Edge::Periodic:
            return "Periodic";
        case Edge::Wall:
            return "Wall";
        default:
            return "Open";
    }
}

Bench::Bench(const Scene& wanted)
    : scene(wanted),
      pool(wanted.threads),
      state({wanted.width, wanted.height}, wanted.cell_mm),
      solver(std::make_unique<Solver>(state, medium_of(wanted), options_of(wanted), pool)) {
    solver->set_gravity({scene.gravity, scene.force_x, scene.force_y});
}

void Bench::fill(const std::function<double(int, int)>& thickness) {
    for (int y = 0; y < scene.height; ++y)
        for (int x = 0; x < scene.width; ++x)
            state.thickness.set(
                x, y, static_cast<std::int32_t>(std::lround(thickness(x, y) / kThicknessQuantum_mm)));
    solver->wake_all();
}

void Bench::tint(int channel, const std::function<double(int, int)>& per_mm) {
    for (int y = 0; y < scene.height; ++y)
        for (int x = 0; x < scene.width; ++x) {
            PaintCell cell = state.paint.at(x, y);
            cell[channel] =
                static_cast<std::int32_t>(std::lround(per_mm(x, y) * h(x, y) / kPaintQuantum));
            state.paint.set(x, y, cell);
        }
}

void Bench::carry_consistency() {
    const Consistency consistency = consistency_of(medium_of(scene));
    tint(kViscosityChannel, [&](int, int) { return consistency.log_viscosity; });
    tint(kYieldChannel, [&](int, int) { return consistency.yield_stress_Pa; });
    state.consistencies.add(consistency);
}

void Bench::set_support(const std::function<double(int, int)>& height_mm) {
    for (int y = 0; y < scene.height; ++y)
        for (int x = 0; x < scene.width; ++x)
            state.support_mm.set(x, y, static_cast<float>(height_mm(x, y)));
}

double Bench::volume() const {
    return static_cast<double>(totals(state).thickness) * kThicknessQuantum_mm;
}

double Bench::max_h() const {
    double result = 0.0;
    for (int y = 0; y < scene.height; ++y)
        for (int x = 0; x < scene.width; ++x)
            result = std::max(result, h(x, y));
    return result;
}

AdvanceReport Bench::run(double dt_s, double seconds) {
    AdvanceReport report;
    const long steps = std::lround(seconds / dt_s);
    for (long i = 0; i < steps; ++i)
        report.add(solver->step(dt_s));
    return report;
}

}  // namespace pastoso::film::test
