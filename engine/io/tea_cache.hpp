// A folder of frames of the tea, computed once and drawn as often as wanted (docs/tea-cache.md).
#pragma once

#include "io/tea_file.hpp"

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace pastoso::io {

/// What the frames of a folder have in common; the file "tea.json" in it.
struct TeaCacheIndex {
    std::string scene;             ///< what was poured: the scene as text
    std::uint64_t scene_hash = 0;  ///< noted in every frame as well
    double fps = 30.0;             ///< frames a second of tea, 1 to 1000
    int count = 0;                 ///< how many frames there will be in all, up to a million
    friend bool operator==(const TeaCacheIndex&, const TeaCacheIndex&) = default;
};

/// Writes the index aside into a folder, which is made if need be. Throws InputError when that fails.
void write_tea_index(const std::filesystem::path& folder, const TeaCacheIndex& index);

/// Throws InputError when it cannot be read or is not sound.
TeaCacheIndex read_tea_index(const std::filesystem::path& folder);

/// "FOLDER/frame_000123.tea". Frames are counted from 1: frame n is the tea at n / fps seconds.
std::filesystem::path tea_frame_path(const std::filesystem::path& folder, int frame);

/// Which frames, from 1 on, are whole and belong to the scene; every file is read. A run that was
/// stopped goes on with the others.
std::vector<bool> whole_tea_frames(const std::filesystem::path& folder, const TeaCacheIndex& index);

}  // namespace pastoso::io
