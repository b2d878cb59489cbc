#include "liquid_files/run_stats.hpp"

#include "core/memory.hpp"
#include "core/number_text.hpp"
#include "core/text_file.hpp"

#include <nlohmann/json.hpp>

namespace pastoso::liquid_files {

void write_run_stats(const std::filesystem::path& path, const RunStats& stats,
                     const std::vector<Figure>& own) {
    const double steps_per_s =
        stats.simulate_s > 0.0 ? static_cast<double>(stats.steps) / stats.simulate_s : 0.0;
    nlohmann::ordered_json json{
        {"wall_s", stats.wall_s},
        {"simulate_s", stats.simulate_s},
        {"surface_s", stats.files.surface_s},
        {"trace_s", stats.files.trace_s},
        {"denoise_s", stats.files.denoise_s},
        {"io_s", stats.files.io_s},
        {"steps", stats.steps},
        {"steps_per_s", steps_per_s},
        {"frames", stats.files.frames},
        {"triangles", stats.files.triangles},
    };
    for (const auto& [name, figure] : own)
        std::visit([&, key = name](const auto& value) { json[key] = value; }, figure);
    json["pcg_iterations_max"] = stats.pcg_iterations_max;
    json["not_converged"] = stats.not_converged;
    json["state_hash"] = core::hex_text(stats.state_hash);
    json["peak_rss_mib"] = core::peak_rss_mib();
    json["threads"] = stats.threads;
    json["version"] = stats.version;
    core::write_text_file(path, json.dump(2) + "\n");
}

}  // namespace pastoso::liquid_files
