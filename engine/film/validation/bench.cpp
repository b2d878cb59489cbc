#include "film/validation/bench.hpp"

#include "core/units.hpp"
#include "film/cell/wet_media.hpp"

#include <algorithm>
#include <cmath>

namespace pastoso::film::validation {
namespace {

constexpr double kDensity_kg_m3 = 1000.0;
constexpr double kTick_s = 1.0 / 60.0;

SolverOptions options_of(const Setup& setup) {
    SolverOptions options = setup.solver;
    options.edge_x = setup.edge_x;
    options.edge_y = setup.edge_y;
    options.inertia = setup.inertia;
    options.lateral_drag = setup.lateral;
    options.horizontal_tension = setup.horizontal_tension;
    options.full_curvature = setup.full_curvature;
    options.sleeping = setup.sleeping;
    return options;
}

}  // namespace

Medium medium_of(const Setup& setup) {
    Medium medium;
    medium.name = "test paint";
    medium.density_kg_m3 = kDensity_kg_m3;
    medium.viscosity_m2_s = setup.viscosity * 1e-6;
    medium.surface_tension_N_m = setup.tension * 1e-9 * kDensity_kg_m3;
    medium.yield_stress_Pa = setup.yield * 1e-6 * kDensity_kg_m3;
    medium.flow_index = setup.flow_index;
    medium.structure_share = setup.structure_share;
    medium.recovery_s = setup.recovery_s;
    medium.breakdown_strain = setup.breakdown_strain;
    medium.alpha_min = setup.alpha_min;
    medium.alpha_max = setup.alpha_max;
    medium.advancing_angle_deg = core::degrees(std::atan(setup.tan_advancing));
    medium.receding_angle_deg = core::degrees(std::atan(setup.tan_receding));
    medium.slip_cells = setup.slip_cells;
    return medium;
}

Bench::Bench(const Setup& wanted)
    : setup(wanted),
      pool(wanted.threads),
      state({wanted.width, wanted.height}, wanted.cell_mm),
      solver(std::make_unique<Solver>(state, medium_of(wanted), options_of(wanted), pool)) {
    solver->set_gravity({setup.gravity, setup.force_x, setup.force_y});
}

void Bench::fill(const std::function<double(int, int)>& thickness) {
    for (int y = 0; y < setup.height; ++y)
        for (int x = 0; x < setup.width; ++x)
            state.thickness.set(
                x, y, static_cast<std::int32_t>(std::lround(thickness(x, y) / kThicknessQuantum_mm)));
    solver->wake_all();
}

void Bench::set_support(const std::function<double(int, int)>& height_mm) {
    for (int y = 0; y < setup.height; ++y)
        for (int x = 0; x < setup.width; ++x)
            state.support_mm.set(x, y, static_cast<float>(height_mm(x, y)));
}

void Bench::mix_in(const Medium& other, const std::function<double(int, int)>& share) {
    const int medium = add_medium(state, film_numbers_of(other));
    for (int y = 0; y < setup.height; ++y)
        for (int x = 0; x < setup.width; ++x) {
            MediaCell cell{};
            cell[medium] =
                static_cast<std::int32_t>(std::lround(share(x, y) * state.thickness.at(x, y)));
            state.media.foreign.set(x, y, cell);
        }
    solver->wake_all();
}

double Bench::volume() const {
    return static_cast<double>(totals(state).thickness) * kThicknessQuantum_mm;
}

double Bench::max_h() const {
    double result = 0.0;
    for (int y = 0; y < setup.height; ++y)
        for (int x = 0; x < setup.width; ++x)
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

void Bench::pass(double seconds) {
    const double ticks = std::floor(seconds / kTick_s + 1e-6);
    for (double tick = 0; tick < ticks; ++tick) {
        setup.watch();
        solver->advance(kTick_s);
    }
    const double rest_s = seconds - ticks * kTick_s;
    if (rest_s > 1e-6 * kTick_s) solver->advance(rest_s);
    passed_s += seconds;
}

}  // namespace pastoso::film::validation
