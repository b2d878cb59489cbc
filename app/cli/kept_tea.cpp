#include "cli/kept_tea.hpp"

#include "core/looking.hpp"
#include "liquid_files/tea_checkpoint.hpp"

#include <algorithm>

namespace pastoso::cli {

KeptTea::KeptTea(const std::filesystem::path& folder, const liquid_files::FrameIndex& index)
    : frames_{folder, index.scene_hash},
      whole_(liquid_files::whole_tea_frames(
          folder, liquid_files::keep_frame_index(folder, liquid_files::kTeaCache, index))) {}

bool KeptTea::has_all(int count) const {
    return std::all_of(whole_.begin(), whole_.begin() + count, [](bool whole) { return whole; });
}

void KeptTea::write(int frame, const liquid::TeaFrame& content) const {
    liquid_files::write_tea_frame(frames_.path_of(frame), content, frames_.scene_hash);
}

std::filesystem::path KeptTea::state_path() const {
    return liquid_files::tea_checkpoint_path(frames_.folder);
}

std::optional<liquid::TeaState> KeptTea::state() const {
    if (!core::is_there(state_path())) return std::nullopt;
    return liquid_files::read_tea_checkpoint(state_path(), frames_.scene_hash);
}

void KeptTea::write_state(const liquid::TeaState& state) const {
    liquid_files::write_tea_checkpoint(state_path(), state, frames_.scene_hash);
}

}  // namespace pastoso::cli
