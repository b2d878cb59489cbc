#include "liquid_files/tea_cache.hpp"

#include <cstdio>

namespace pastoso::liquid_files {

std::filesystem::path tea_frame_path(const std::filesystem::path& folder, int frame) {
    char name[32];
    std::snprintf(name, sizeof name, "frame_%06d.tea", frame);
    return folder / name;
}

std::vector<bool> whole_tea_frames(const std::filesystem::path& folder, const FrameIndex& index) {
    std::vector<bool> whole;
    for (int frame = 1; frame <= index.count; ++frame)
        whole.push_back(is_whole_tea_frame(tea_frame_path(folder, frame), index.scene_hash));
    return whole;
}

}  // namespace pastoso::liquid_files
