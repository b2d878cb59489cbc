// The figures of a run of a tank, and how they went on.
#pragma once

#include "liquid_files/run_stats.hpp"
#include "tank/tank_state.hpp"

#include <cstdint>
#include <string>
#include <vector>

namespace pastoso::liquid_files {

/// A tank at a frame; plain numbers of eight bytes each, as checkpoints keep them.
struct TankSeriesRow {
    double time_s = 0.0;
    double volume_m3 = 0.0;  ///< within the liquid's surface
    /// That against the first row's with what jets brought since and drains took.
    double volume_error_rel = 0.0;
    double front_x_m = 0.0;  ///< tank::TankSurfaces::front_x_m()
    double fastest_m_s = 0.0;
    std::int64_t steps = 0;                ///< from the start
    std::int64_t pressure_iterations = 0;  ///< the most of a step since the row before
    double step_s = 0.0;                   ///< of work for a step since the row before
    friend bool operator==(const TankSeriesRow&, const TankSeriesRow&) = default;
};
static_assert(sizeof(TankSeriesRow) == 64);

/// Comma-separated values with one heading line, which are the names above.
std::string series_csv(const std::vector<TankSeriesRow>& rows);

struct TankStats : RunStats {
    TankSeriesRow end;                      ///< the last row
    double volume_error_rel_max = 0.0;      ///< the largest of all rows, without its sign
    std::int64_t cells = 0, particles = 0;  ///< of the box; at the end
};

/// Of particles, velocity and level; equal liquids give equal hashes.
std::uint64_t state_hash(const tank::TankState& state);

/// See write_run_stats().
void write_stats(const std::filesystem::path& path, const TankStats& stats);

}  // namespace pastoso::liquid_files
