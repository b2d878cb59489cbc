// The times at which a run of a scene is looked at.
#pragma once

#include "recordings/scene_json.hpp"

#include <vector>

namespace pastoso::recordings {

/// Times of a run that lie nearer to each other than this are the same, s.
double time_tolerance_s(const SceneRun& run);

/// Ascending, from 0 to the run's duration: the times of all that is written, those of the series among
/// them. A film is stepped from one to the next, so that they belong to what its bits depend on.
std::vector<double> stops_of(const SceneRun& run);

}  // namespace pastoso::recordings
