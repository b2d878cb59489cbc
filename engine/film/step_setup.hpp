// What a medium, gravity and the options make of the constants of a step.
#pragma once

#include "film/cell/film_numbers.hpp"
#include "film/explicit/step_length.hpp"
#include "film/solver.hpp"
#include "film/step_constants.hpp"

#include <vector>

namespace pastoso::film {

/// Checks that the solver can do a medium: density and viscosity above 0, 0.2 <= flow_index <= 1,
/// 1/3 < alpha_min <= alpha_max, 0 <= structure_share < 1, recovery time and breakdown strain above 0,
/// receding <= advancing angle.
void check_medium(const Medium& medium);

CellNumbers<float> cell_numbers(const FilmNumbers& numbers, double cell_mm);

/// Numbers for what a step over several media asks of all of them: with those no step is too long for
/// one, and no term is left out that one has. An advancing angle of 0 only if all have it.
FilmNumbers bounds_of(const std::vector<FilmNumbers>& media);
bool tensions_differ(const std::vector<FilmNumbers>& media);

/// What bounds the length of a step in a medium.
StepLimits make_limits(const Medium& medium, const Gravity& gravity, double cell_mm);

/// The constants of a step in the solver's own units, but for its length.
StepConstants make_constants(const Medium& medium, const Gravity& gravity, const SolverOptions& options,
                             double cell_mm);

}  // namespace pastoso::film
