// What a medium, gravity and the options make of the constants of a step.
#pragma once

#include "film/explicit/step_length.hpp"
#include "film/solver.hpp"
#include "film/step_constants.hpp"

namespace pastoso::film {

/// Checks that the solver can do a medium: density and viscosity above 0, 0.2 <= flow_index <= 1,
/// 1/3 < alpha_min <= alpha_max, 0 <= structure_share < 1, recovery time and breakdown strain above 0,
/// receding <= advancing angle.
void check_medium(const Medium& medium);

/// What bounds the length of a step in a medium.
StepLimits make_limits(const Medium& medium, const Gravity& gravity, double cell_mm);

/// The constants of a step in the solver's own units, but for its length.
StepConstants make_constants(const Medium& medium, const Gravity& gravity, const SolverOptions& options,
                             double cell_mm);

}  // namespace pastoso::film
