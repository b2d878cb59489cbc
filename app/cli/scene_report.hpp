// What came of the runs of a scene, side by side.
#pragma once

#include "cli/scene_writer.hpp"

#include <string>
#include <vector>

namespace pastoso::cli {

/// One run with its moments; empty name for the single run of a file.
struct RunOutcome {
    std::string name;
    std::vector<SceneMoment> moments;
    std::vector<recordings::SeriesRow> series;
    std::vector<pigment::Image8> pictures;
    SceneTimes times;
    double film_s = 0.0;
    film::AdvanceReport film;
    std::uint64_t state_hash = 0;
};

/// {"title", "runs": [{"name", "moments": [{"t_s", "picture", "volume", "max_h", "front": {...}}]}]},
/// lengths with their unit in the name; the same bytes on any number of threads.
std::string report_json(const recordings::SceneFile& file, const std::vector<RunOutcome>& outcomes);

/// The last moment of every run as a table for people.
std::string report_table(const recordings::SceneFile& file, const std::vector<RunOutcome>& outcomes);

/// Times and counts of all runs, for --stats.
std::string simulate_stats_json(const std::vector<RunOutcome>& outcomes, int threads, double wall_s);

}  // namespace pastoso::cli
