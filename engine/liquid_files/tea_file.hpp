// One moment of the tea as a compressed file (docs/tea-cache.md).
#pragma once

#include "liquid/tea/tea_frame.hpp"

#include <cstdint>
#include <filesystem>

namespace pastoso::liquid_files {

inline constexpr int kTeaFileVersion = 3;
inline constexpr int kMostTeaCellsAlong = 1024;
inline constexpr std::int64_t kMostTeaCells = std::int64_t{1} << 27;
inline constexpr std::int64_t kMostTeaParcels = 10'000'000;

/// Writes the frame aside. Ghosts are not kept. `scene_hash` names what the frame belongs to. The frame
/// is within the limits above. Throws InputError when the file cannot be written.
void write_tea_frame(const std::filesystem::path& path, const liquid::TeaFrame& frame,
                     std::uint64_t scene_hash);

/// The frame; ghosts are 0. Throws InputError when the file cannot be read, is none of these, is of a
/// newer version, is damaged, belongs to another scene, or holds what is not finite. No more is
/// allocated than a whole file of its size may hold.
liquid::TeaFrame read_tea_frame(const std::filesystem::path& path, std::uint64_t scene_hash);

/// Whether the file is there, whole by its checksum, and of this scene; nothing is decompressed.
bool is_whole_tea_frame(const std::filesystem::path& path, std::uint64_t scene_hash);

}  // namespace pastoso::liquid_files
