#include "liquid_files/tank_stats.hpp"

#include "core/hash.hpp"
#include "files/number_rows.hpp"

#include <span>

namespace pastoso::liquid_files {

std::string series_csv(const std::vector<TankSeriesRow>& rows) {
    std::string text =
        "time_s,volume_m3,volume_error_rel,front_x_m,fastest_m_s,steps,pressure_iterations,step_s\n";
    for (const TankSeriesRow& row : rows) {
        files::append_numbers(text, {row.time_s, row.volume_m3, row.volume_error_rel, row.front_x_m,
                                     row.fastest_m_s, static_cast<double>(row.steps),
                                     static_cast<double>(row.pressure_iterations), row.step_s});
        text += '\n';
    }
    return text;
}

std::uint64_t state_hash(const tank::TankState& state) {
    core::Hash64 hash;
    hash.add(std::span<const tank::Particle>(state.liquid.particles));
    for (const grid::BoxField* field :
         {&state.liquid.velocity.x, &state.liquid.velocity.y, &state.liquid.velocity.z})
        hash.add(std::span<const float>(field->values()));
    if (state.liquid.level) hash.add(std::span<const float>(state.liquid.level->level_m.values()));
    return hash.value();
}

void write_stats(const std::filesystem::path& path, const TankStats& stats) {
    write_run_stats(path, stats,
                    {{"seconds", stats.end.time_s},
                     {"cells", stats.cells},
                     {"particles", stats.particles},
                     {"volume_m3", stats.end.volume_m3},
                     {"volume_error_rel", stats.end.volume_error_rel},
                     {"volume_error_rel_max", stats.volume_error_rel_max},
                     {"front_x_m", stats.end.front_x_m}});
}

}  // namespace pastoso::liquid_files
