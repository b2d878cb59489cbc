// The state of a tea as a compressed file, for a simulation that goes on another time
// (docs/tea-cache.md).
#pragma once

#include "liquid/tea/tea_state.hpp"

#include <cstdint>
#include <filesystem>

namespace pastoso::liquid_files {

inline constexpr int kTeaCheckpointVersion = 3;

/// "FOLDER/checkpoint.tea", beside the frames.
std::filesystem::path tea_checkpoint_path(const std::filesystem::path& folder);

/// Writes the state aside. `scene_hash` names what it belongs to. Throws InputError when the file cannot
/// be written.
void write_tea_checkpoint(const std::filesystem::path& path, const liquid::TeaState& state,
                          std::uint64_t scene_hash);

/// The state, to the last bit. Throws InputError as read_tea_frame() does; whether it is one of the
/// glass it is given to, MilkTea::set_state() finds out.
liquid::TeaState read_tea_checkpoint(const std::filesystem::path& path, std::uint64_t scene_hash);

}  // namespace pastoso::liquid_files
