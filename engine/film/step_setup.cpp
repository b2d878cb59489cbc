#include "film/step_setup.hpp"

#include "core/check.hpp"
#include "core/units.hpp"

#include <algorithm>
#include <cmath>

namespace pastoso::film {
namespace {

double drag_coefficient(double alpha) {
    return 6.0 / (3.0 * alpha - 1.0);
}

}  // namespace

StepLimits make_limits(const Medium& medium, const Gravity& gravity, double cell_mm) {
    StepLimits limits;
    limits.cell_mm = cell_mm;
    limits.gravity_mm_s2 = gravity.normal_mm_s2;
    limits.tension = medium.surface_tension_N_m / medium.density_kg_m3 * 1e9;
    limits.viscosity_mm2_s = medium.viscosity_m2_s * 1e6;
    limits.smallest_drag = drag_coefficient(medium.alpha_max);
    limits.force_mm_s2 = std::hypot(gravity.x_mm_s2, gravity.y_mm_s2);
    limits.yield = medium.yield_stress_Pa / medium.density_kg_m3 * 1e6;
    limits.flow_index = medium.flow_index;
    limits.structure_share = medium.structure_share;
    return limits;
}

CellNumbers<float> cell_numbers(const FilmNumbers& numbers, double cell_mm) {
    const auto tangent = [](double angle_deg) {
        return static_cast<float>(std::tan(core::radians(angle_deg)));
    };
    return {.density_kg_m3 = static_cast<float>(numbers.density_kg_m3),
            .tension = static_cast<float>(numbers.surface_tension_N_m / numbers.density_kg_m3 * 1e9),
            .flow_index = static_cast<float>(numbers.flow_index),
            .drag_against = static_cast<float>(drag_coefficient(numbers.alpha_min)),
            .drag_along = static_cast<float>(drag_coefficient(numbers.alpha_max)),
            .slip_mm = static_cast<float>(numbers.slip_cells * cell_mm),
            .tan_advancing = tangent(numbers.advancing_angle_deg),
            .tan_receding = tangent(numbers.receding_angle_deg)};
}

StepConstants make_constants(const Medium& medium, const Gravity& gravity, const SolverOptions& options,
                             double cell_mm) {
    const CellNumbers<float> numbers = cell_numbers(film_numbers_of(medium), cell_mm);
    StepConstants step;
    step.cell_mm = static_cast<float>(cell_mm);
    step.inverse_cell = static_cast<float>(1.0 / cell_mm);
    step.gravity_mm_s2 = static_cast<float>(gravity.normal_mm_s2);
    step.force_x_mm_s2 = static_cast<float>(gravity.x_mm_s2);
    step.force_y_mm_s2 = static_cast<float>(gravity.y_mm_s2);
    step.tension = numbers.tension;
    step.viscosity_mm2_s = static_cast<float>(medium.viscosity_m2_s * 1e6);
    step.yield_per_Pa = static_cast<float>(1e6 / medium.density_kg_m3);
    step.yield = static_cast<float>(medium.yield_stress_Pa / medium.density_kg_m3 * 1e6);
    step.drag_against = numbers.drag_against;
    step.drag_along = numbers.drag_along;
    step.slip_mm = numbers.slip_mm;
    step.tan_advancing = numbers.tan_advancing;
    step.tan_receding = numbers.tan_receding;
    step.wet_mm = static_cast<float>(1e-4 * cell_mm);
    step.inertia = options.inertia ? 1.0F : 0.0F;
    step.lateral = options.lateral_drag ? 1.0F : 0.0F;
    step.tension_rise2 = options.tension_in_space ? 1.0F : 0.0F;
    step.horizontal_tension = static_cast<float>(
        options.horizontal_tension * (medium.surface_tension_N_m / medium.density_kg_m3 * 1e9));
    step.flow_index = numbers.flow_index;
    step.structure_share = static_cast<float>(medium.structure_share);
    step.breakdown_strain = static_cast<float>(medium.breakdown_strain);
    step.full_curvature = options.full_curvature;
    return step;
}

FilmNumbers bounds_of(const std::vector<FilmNumbers>& media) {
    PASTOSO_CHECK(!media.empty());
    FilmNumbers bounds = media.front();
    double tension = 0.0, least_advancing_deg = 0.0;
    for (const FilmNumbers& medium : media) {
        bounds.density_kg_m3 = std::max(bounds.density_kg_m3, medium.density_kg_m3);
        bounds.flow_index = std::min(bounds.flow_index, medium.flow_index);
        bounds.structure_share = std::max(bounds.structure_share, medium.structure_share);
        bounds.alpha_min = std::min(bounds.alpha_min, medium.alpha_min);
        bounds.alpha_max = std::max(bounds.alpha_max, medium.alpha_max);
        bounds.slip_cells = std::max(bounds.slip_cells, medium.slip_cells);
        tension = std::max(tension, medium.surface_tension_N_m / medium.density_kg_m3);
        if (medium.advancing_angle_deg > 0.0 &&
            (least_advancing_deg == 0.0 || medium.advancing_angle_deg < least_advancing_deg))
            least_advancing_deg = medium.advancing_angle_deg;
    }
    bounds.surface_tension_N_m = tension * bounds.density_kg_m3;
    bounds.advancing_angle_deg = least_advancing_deg;
    bounds.receding_angle_deg = std::min(bounds.receding_angle_deg, least_advancing_deg);
    return bounds;
}

bool tensions_differ(const std::vector<FilmNumbers>& media) {
    return std::any_of(media.begin(), media.end(), [&](const FilmNumbers& medium) {
        return medium.surface_tension_N_m != media.front().surface_tension_N_m;
    });
}

void check_medium(const Medium& medium) {
    PASTOSO_CHECK_OP(medium.density_kg_m3, >, 0.0);
    PASTOSO_CHECK_OP(medium.viscosity_m2_s, >, 0.0);
    PASTOSO_CHECK_OP(medium.flow_index, >=, 0.2);
    PASTOSO_CHECK_OP(medium.flow_index, <=, 1.0);
    PASTOSO_CHECK_OP(medium.alpha_min, >, 1.0 / 3.0);
    PASTOSO_CHECK_OP(medium.alpha_min, <=, medium.alpha_max);
    PASTOSO_CHECK_OP(medium.structure_share, >=, 0.0);
    PASTOSO_CHECK_OP(medium.structure_share, <, 1.0);
    PASTOSO_CHECK_OP(medium.recovery_s, >, 0.0);
    PASTOSO_CHECK_OP(medium.breakdown_strain, >, 0.0);
    PASTOSO_CHECK_OP(medium.receding_angle_deg, <=, medium.advancing_angle_deg);
}

}  // namespace pastoso::film
