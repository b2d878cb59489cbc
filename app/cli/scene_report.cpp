#include "cli/scene_report.hpp"

#include "core/memory.hpp"
#include "core/version.hpp"
#include "files/json_place.hpp"

#include <algorithm>
#include <cstdio>

namespace pastoso::cli {
namespace {

using files::Json;

Json front_json(const film::Front& front, const std::string& length) {
    return {{"tip" + length, front.tip_mm},       {"width" + length, front.width_mm},
            {"radius" + length, front.radius_mm}, {"roundness", front.roundness},
            {"fullness", front.fullness},         {"thickness" + length, front.thickness_mm}};
}

Json moment_json(const SceneMoment& moment, bool cell_units) {
    const std::string length = cell_units ? "_cells" : "_mm";
    Json json = {{"t_s", moment.t_s},
                 {"picture", moment.picture},
                 {"volume" + length + "3", moment.measures.volume_mm3},
                 {"max_h" + length, moment.measures.max_h_mm}};
    if (moment.front) json["front"] = front_json(*moment.front, length);
    return json;
}

std::string hex(std::uint64_t value) {
    char text[17];
    std::snprintf(text, sizeof text, "%016llx", static_cast<unsigned long long>(value));
    return text;
}

Json run_stats(const RunOutcome& outcome) {
    return {{"name", outcome.name},
            {"film_s", outcome.film_s},
            {"shade_s", outcome.times.shade_s},
            {"io_s", outcome.times.io_s},
            {"film_steps", outcome.film.steps},
            {"cells_stepped", outcome.film.cells_stepped},
            {"large_steps", outcome.film.large_steps},
            {"rejected_steps", outcome.film.rejected_steps},
            {"sweeps", outcome.film.sweeps},
            {"clamped_faces", outcome.film.clamped_faces},
            {"limited_cells", outcome.film.limited_cells},
            {"lagging_steps", outcome.film.lagging_steps},
            {"largest_speed_mm_s", outcome.film.largest_speed_mm_s},
            {"state_hash", hex(outcome.state_hash)}};
}

std::string table_line(const RunOutcome& outcome, std::size_t name_width) {
    char text[256];
    const recordings::SeriesRow& last = outcome.series.back();
    int length = std::snprintf(text, sizeof text, "%-*s %8.4g %8.4g", static_cast<int>(name_width),
                               outcome.name.c_str(), last.t_s, last.measures.max_h_mm);
    if (!outcome.moments.empty() && outcome.moments.back().front) {
        const film::Front& front = *outcome.moments.back().front;
        length += std::snprintf(text + length, sizeof text - static_cast<std::size_t>(length),
                                " %8.4g %8.4g %8.4g %8.4g %8.3f %8.3f", front.tip_mm, front.thickness_mm,
                                front.width_mm, front.radius_mm, front.roundness, front.fullness);
    }
    return std::string(text) + "\n";
}

}  // namespace

std::string report_json(const recordings::SceneFile& file, const std::vector<RunOutcome>& outcomes) {
    Json runs = Json::array();
    for (const RunOutcome& outcome : outcomes) {
        Json moments = Json::array();
        for (const SceneMoment& moment : outcome.moments)
            moments.push_back(moment_json(moment, file.cell_units));
        Json run = Json::object();
        if (!outcome.name.empty()) run["name"] = outcome.name;
        run["moments"] = std::move(moments);
        runs.push_back(std::move(run));
    }
    return Json{{"title", file.title}, {"runs", std::move(runs)}}.dump(2) + "\n";
}

std::string report_table(const recordings::SceneFile& file, const std::vector<RunOutcome>& outcomes) {
    std::size_t name_width = 3;
    for (const RunOutcome& outcome : outcomes)
        name_width = std::max(name_width, outcome.name.size());
    char heading[256];
    std::snprintf(heading, sizeof heading, "%-*s %8s %8s %8s %8s %8s %8s %8s %8s  (lengths in %s)\n",
                  static_cast<int>(name_width), "run", "t_s", "max_h", "tip", "front_h", "width",
                  "radius", "round", "full", file.cell_units ? "cells" : "mm");
    std::string table = heading;
    for (const RunOutcome& outcome : outcomes)
        table += table_line(outcome, name_width);
    return table;
}

std::string simulate_stats_json(const std::vector<RunOutcome>& outcomes, int threads, double wall_s) {
    Json runs = Json::array();
    double film_s = 0.0, cells = 0.0;
    for (const RunOutcome& outcome : outcomes) {
        runs.push_back(run_stats(outcome));
        film_s += outcome.film_s;
        cells += static_cast<double>(outcome.film.cells_stepped);
    }
    const Json json = {{"wall_s", wall_s},
                       {"film_s", film_s},
                       {"film_mcells_per_s", film_s > 0.0 ? 1e-6 * cells / film_s : 0.0},
                       {"runs", runs},
                       {"peak_rss_mib", core::peak_rss_mib()},
                       {"threads", threads},
                       {"version", core::version()}};
    return json.dump(2) + "\n";
}

}  // namespace pastoso::cli
