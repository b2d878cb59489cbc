// The folder that "tea --cache" fills: frames of one scene, and the state to go on from.
#pragma once

#include "liquid/tea/tea_frame.hpp"
#include "liquid/tea/tea_state.hpp"
#include "liquid_files/tea_cache.hpp"

#include <filesystem>
#include <optional>
#include <vector>

namespace pastoso::cli {

/// Frames of one scene in a folder.
struct KeptFrames {
    std::filesystem::path folder;
    std::uint64_t scene_hash = 0;

    std::filesystem::path path_of(int frame) const {
        return liquid_files::tea_frame_path(folder, frame);
    }
    liquid::TeaFrame read(int frame) const {
        return liquid_files::read_tea_frame(path_of(frame), scene_hash);
    }
};

class KeptTea {
  public:
    /// Makes the folder's index, or lengthens it. Throws InputError when the folder keeps other tea.
    KeptTea(const std::filesystem::path& folder, const liquid_files::FrameIndex& index);

    const KeptFrames& frames() const { return frames_; }

    /// Whether a frame was there, whole, when the folder was opened.
    bool has(int frame) const { return whole_.at(static_cast<std::size_t>(frame) - 1); }
    /// The same of frames 1 to `count`.
    bool has_all(int count) const;
    void write(int frame, const liquid::TeaFrame& content) const;

    /// The state that was kept last; none where none was. Throws InputError when it is damaged or of
    /// another scene.
    std::optional<liquid::TeaState> state() const;
    void write_state(const liquid::TeaState& state) const;
    std::filesystem::path state_path() const;

  private:
    KeptFrames frames_;
    std::vector<bool> whole_;
};

}  // namespace pastoso::cli
