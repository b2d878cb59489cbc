#include "recordings/scene_stops.hpp"

#include <algorithm>
#include <iterator>

namespace pastoso::recordings {
namespace {

/// Those that are asked for by name, and both ends.
std::vector<double> asked_times(const SceneRun& run) {
    std::vector<double> asked = {0.0, run.scene.duration_s};
    for (const auto* times :
         {&run.output.pictures_at_s, &run.output.heights_at_s, &run.output.profiles_at_s})
        asked.insert(asked.end(), times->begin(), times->end());
    if (run.output.magnification) asked.push_back(run.output.magnification->at_s);
    std::sort(asked.begin(), asked.end());
    asked.erase(std::unique(asked.begin(), asked.end()), asked.end());
    return asked;
}

}  // namespace

double time_tolerance_s(const SceneRun& run) {
    return 1e-9 * std::max(run.scene.duration_s, 1e-3);
}

std::vector<double> stops_of(const SceneRun& run) {
    const double end_s = run.scene.duration_s, same = time_tolerance_s(run);
    const std::vector<double> asked = asked_times(run);
    // Those of the series that are not among them but for rounding.
    std::vector<double> series;
    for (long i = 1; static_cast<double>(i) * run.output.series_every_s < end_s - same; ++i) {
        const double time_s = static_cast<double>(i) * run.output.series_every_s;
        const auto next = std::lower_bound(asked.begin(), asked.end(), time_s - same);
        if (*next > time_s + same) series.push_back(time_s);
    }
    std::vector<double> stops;
    std::merge(asked.begin(), asked.end(), series.begin(), series.end(), std::back_inserter(stops));
    return stops;
}

}  // namespace pastoso::recordings
