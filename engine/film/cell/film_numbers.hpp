// The numbers of a medium that the channels of its paint do not hold (paint_cell.hpp).
#pragma once

#include <span>

namespace pastoso::film {

struct Medium;

/// As in Medium, in its units and ranges. Those of a mixture are the means by volume.
struct FilmNumbers {
    double density_kg_m3, flow_index, structure_share, recovery_s, breakdown_strain, surface_tension_N_m,
        advancing_angle_deg, receding_angle_deg, slip_cells, alpha_min, alpha_max;
    friend bool operator==(const FilmNumbers&, const FilmNumbers&) = default;
};
/// Each of them, and which of a medium it is.
struct FilmNumber {
    double FilmNumbers::*of_film;
    double Medium::*of_medium;
};
std::span<const FilmNumber> film_number_list();

FilmNumbers film_numbers_of(const Medium& medium);
/// The medium with these numbers instead of its own.
Medium with_film_numbers(const Medium& medium, const FilmNumbers& numbers);

/// Those that a step follows from cell to cell, in the step's own units (step_constants.hpp): of one
/// cell or face, or F the values of many.
template <class F>
struct CellNumbers {
    F density_kg_m3;
    F tension;  ///< sigma/rho
    F flow_index, drag_against, drag_along, slip_mm, tan_advancing, tan_receding;
};

}  // namespace pastoso::film
