// Runs of cases: which there are, and what came of them.
#pragma once

#include "core/thread_pool.hpp"
#include "film/validation/case.hpp"

#include <functional>
#include <string>
#include <vector>

namespace pastoso::film::validation {

/// A run of a case; once it is done, with its outcome.
struct ValidatedRun {
    const Case* wanted = nullptr;
    Run run;
    Outcome outcome;
};

/// "explicit", "large", or "both"; empty for any other name.
std::vector<Scheme> schemes_named(const std::string& name);

/// The runs of the cases named, of all where none is, in their order, by these schemes. Those that take
/// minutes are left out unless `with_long`. Throws InputError for a name that there is not.
std::vector<ValidatedRun> planned_runs(const std::vector<std::string>& names,
                                       const std::vector<Scheme>& schemes, bool with_long);

/// Carries all of them out beside each other, each on one thread of the pool. On any of these `watch` is
/// called at every tick, and may throw to stop, and `done` after a run, one at a time, with the share
/// of runs that are done.
void carry_out(std::vector<ValidatedRun>& runs, core::ThreadPool& pool,
               const std::function<void()>& watch, const std::function<void(double share)>& done);

/// "explicit" or "large".
std::string name_of(Scheme scheme);

/// The direction that a figure was measured in, degrees against the grid.
double angle_of(const ValidatedRun& run, const Figure& figure);

}  // namespace pastoso::film::validation
