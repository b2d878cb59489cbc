#include "io/tea_stats.hpp"

#include "core/text_file.hpp"
#include "io/replay_stats.hpp"

#include <nlohmann/json.hpp>

namespace pastoso::io {

void write_stats(const std::filesystem::path& path, const TeaStats& stats) {
    const double steps_per_s =
        stats.simulate_s > 0.0 ? static_cast<double>(stats.steps) / stats.simulate_s : 0.0;
    const nlohmann::ordered_json json{
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
        {"parcels", stats.parcels},
        {"balls", stats.balls},
        {"milk_error_rel", stats.milk_error_rel},
        {"divergence_max", stats.divergence_max},
        {"pcg_iterations_max", stats.pcg_iterations_max},
        {"not_converged", stats.not_converged},
        {"surface_error_rel", stats.files.surface_error_rel},
        {"pile_up_dispersion", stats.pile_up_dispersion},
        {"pile_up_at_borders", stats.pile_up_at_borders},
        {"state_hash", hex_text(stats.state_hash)},
        {"peak_rss_mib", peak_rss_mib()},
        {"threads", stats.threads},
        {"version", stats.version},
    };
    core::write_text_file(path, json.dump(2) + "\n");
}

}  // namespace pastoso::io
