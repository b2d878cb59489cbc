#include "film/cell/film_numbers.hpp"

#include "film/medium.hpp"

namespace pastoso::film {

FilmNumbers film_numbers_of(const Medium& medium) {
    return {.density_kg_m3 = medium.density_kg_m3,
            .flow_index = medium.flow_index,
            .structure_share = medium.structure_share,
            .recovery_s = medium.recovery_s,
            .breakdown_strain = medium.breakdown_strain,
            .surface_tension_N_m = medium.surface_tension_N_m,
            .advancing_angle_deg = medium.advancing_angle_deg,
            .receding_angle_deg = medium.receding_angle_deg,
            .slip_cells = medium.slip_cells,
            .alpha_min = medium.alpha_min,
            .alpha_max = medium.alpha_max};
}

Medium with_film_numbers(const Medium& medium, const FilmNumbers& numbers) {
    Medium result = medium;
    result.density_kg_m3 = numbers.density_kg_m3;
    result.flow_index = numbers.flow_index;
    result.structure_share = numbers.structure_share;
    result.recovery_s = numbers.recovery_s;
    result.breakdown_strain = numbers.breakdown_strain;
    result.surface_tension_N_m = numbers.surface_tension_N_m;
    result.advancing_angle_deg = numbers.advancing_angle_deg;
    result.receding_angle_deg = numbers.receding_angle_deg;
    result.slip_cells = numbers.slip_cells;
    result.alpha_min = numbers.alpha_min;
    result.alpha_max = numbers.alpha_max;
    return result;
}

}  // namespace pastoso::film
