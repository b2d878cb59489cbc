#include "recordings/replay_stats.hpp"

#include "core/memory.hpp"
#include "core/number_text.hpp"
#include "core/text_file.hpp"

#include <nlohmann/json.hpp>

namespace pastoso::recordings {

std::string stats_json(const ReplayStats& stats) {
    const document::Account& account = stats.account;
    const nlohmann::ordered_json json{
        {"wall_s", stats.wall_s},
        {"brush_s", stats.brush_s},
        {"film_s", stats.film_s},
        {"shade_s", stats.shade_s},
        {"io_s", stats.io_s},
        {"steps", stats.film.steps},
        {"cells_stepped", stats.film.cells_stepped},
        {"wet_cells", stats.wet_cells},
        {"volume_in_mm3", account.taken.volume_mm3},
        {"volume_canvas_mm3", account.canvas.volume_mm3},
        {"volume_dried_mm3", account.dried.volume_mm3},
        {"volume_brush_mm3", account.brush.volume_mm3},
        {"volume_well_mm3", account.well.volume_mm3},
        {"volume_ledger_mm3", account.ledger.volume_mm3},
        {"volume_error_rel", account.volume_error_rel()},
        {"pigment_error_rel", account.pigment_error_rel()},
        {"clamped_faces", stats.film.clamped_faces},
        {"state_hash", core::hex_text(stats.state_hash)},
        {"image_hash", core::hex_text(stats.image_hash)},
        {"peak_rss_mib", core::peak_rss_mib()},
        {"threads", stats.threads},
        {"version", stats.version},
    };
    return json.dump(2) + "\n";
}

void write_stats(const std::filesystem::path& path, const ReplayStats& stats) {
    core::write_text_file(path, stats_json(stats));
}

}  // namespace pastoso::recordings
