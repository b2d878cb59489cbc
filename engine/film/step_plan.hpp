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
    bool pulled;         ///< where tension differs, it pulls paint along
    core::ThreadPool& pool;
};

/// Paint that its weight or the air carries faster than these steps allow lags behind: a large step lets
/// it feel as much of its weight as it can follow, and cells give what they hold.
inline constexpr double kMostLargeSteps_per_s = 1200.0;

struct StepPlan {
    double step_s;
    bool large;
    bool lags = false;  ///< paint is carried faster than the most steps a second follow
};

/// The next step towards the end of `seconds`; may be longer than what is left. An explicit one stays
/// below the stability limit of every tile. In a large one the body force carries no paint further than
/// a fifth of a cell and the air about one cell, or in kMostLargeSteps_per_s what they allow; the waves
/// may be of any speed.
StepPlan plan_step(const PlannedFilm& film, const SolverOptions& options, double seconds);

/// A large step longer than a tick of 60 a second, and than paint may wait, is for paint that hardly
/// moves: it is planned by the speeds of the step before, and solved closely.
bool is_unhurried(double dt_s, const SolverOptions& options);

/// Whether an unhurried step has moved paint so much farther than planned, at this largest speed, that
/// it has to be done again in halves.
bool went_too_far(double dt_s, double speed_mm_s, double cell_mm);

}  // namespace pastoso::film
