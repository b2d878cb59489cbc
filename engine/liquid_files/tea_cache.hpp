// A folder of frames of the tea, computed once and drawn as often as wanted (docs/tea-cache.md).
#pragma once

#include "liquid_files/frame_index.hpp"
#include "liquid_files/tea_file.hpp"

#include <filesystem>
#include <vector>

namespace pastoso::liquid_files {

inline constexpr FrameIndexKind kTeaCache = {"tea.json", "pastoso-tea-cache",
                                             core::Pattern<0>("other tea")};

/// "FOLDER/frame_000123.tea". Frames are counted from 1: frame n is the tea at n / fps seconds.
std::filesystem::path tea_frame_path(const std::filesystem::path& folder, int frame);

/// Which frames, from 1 on, are whole and belong to the scene; every file is read. A run that was
/// stopped goes on with the others.
std::vector<bool> whole_tea_frames(const std::filesystem::path& folder, const FrameIndex& index);

}  // namespace pastoso::liquid_files
