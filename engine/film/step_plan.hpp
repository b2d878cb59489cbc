// How to get through some time: in explicit steps below the stability limit or in large ones.
#pragma once

#include "core/thread_pool.hpp"
#include "film/air_jet.hpp"
#include "film/explicit/step_length.hpp"
#include "film/solver.hpp"
#include "film/tile_activity.hpp"

#include <vector>

namespace pastoso::film {

/// What a step is planned for: the tiles of `activity` that take part.
struct PlannedFilm {
    const FilmState& state;
    const ActivityMap& activity;
    const StepLimits& limits;
    const std::vector<AirJet>& air;
    double density_kg_m3;
    bool mixed, varied;  ///< as of StepConstants
    core::ThreadPool& pool;
};

struct StepPlan {
    double step_s;
    bool large;
};

/// The next step towards the end of `seconds`; may be longer than what is left. An explicit one stays
/// below the stability limit of every tile. In a large one the body force carries no paint further than
/// a fifth of a cell and the air about one cell; the waves may be of any speed.
StepPlan plan_step(const PlannedFilm& film, const SolverOptions& options, double seconds);

}  // namespace pastoso::film
