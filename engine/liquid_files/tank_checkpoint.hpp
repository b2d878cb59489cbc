// The state of a tank as a compressed file, for a simulation that goes on another time
// (docs/tank-frames.md).
#pragma once

#include "liquid_files/tank_stats.hpp"
#include "tank/tank_state.hpp"

#include <cstdint>
#include <filesystem>
#include <vector>

namespace pastoso::liquid_files {

inline constexpr int kTankCheckpointVersion = 2;

/// A tank at a frame, and how it came there: a row for each frame from 0 on.
struct TankCheckpoint {
    tank::TankState state;
    std::vector<TankSeriesRow> series;
    friend bool operator==(const TankCheckpoint&, const TankCheckpoint&) = default;
};

/// "FOLDER/checkpoint.tank", beside the frames.
std::filesystem::path tank_checkpoint_path(const std::filesystem::path& folder);

/// Writes it aside. `scene_hash` names what it belongs to. Throws InputError when the file cannot be
/// written.
void write_tank_checkpoint(const std::filesystem::path& path, const TankCheckpoint& checkpoint,
                           std::uint64_t scene_hash);

/// The same to the last bit. Throws InputError when the file cannot be read, is damaged, of a newer
/// version or of another scene; whether the state is one of the tank it is given to,
/// LiquidTank::set_state() finds out.
TankCheckpoint read_tank_checkpoint(const std::filesystem::path& path, std::uint64_t scene_hash);

}  // namespace pastoso::liquid_files
