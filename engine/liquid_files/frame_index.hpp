// What the frames of a folder have in common, as a JSON file beside them (docs/tea-cache.md).
#pragma once

#include "core/message.hpp"

#include <cstdint>
#include <filesystem>
#include <string>

namespace pastoso::liquid_files {

struct FrameIndex {
    std::string scene;             ///< what was simulated: the scene as text
    std::uint64_t scene_hash = 0;  ///< noted in every file of parts as well
    double fps = 30.0;             ///< frames a second of the liquid's time, 1 to 1000
    int count = 0;                 ///< how many frames there will be in all, up to a million
    friend bool operator==(const FrameIndex&, const FrameIndex&) = default;
};

/// With the hash of the scene.
FrameIndex index_of(std::string scene, double fps, int count);

/// What indexes of one kind have in common.
struct FrameIndexKind {
    const char* file;    ///< its name in the folder
    const char* format;  ///< as the file has it
    core::Pattern<0> other;  ///< "other tea"
};

/// Writes the index aside into a folder, which is made if need be. Throws InputError when that fails.
void write_frame_index(const std::filesystem::path& folder, const FrameIndexKind& kind,
                       const FrameIndex& index);

/// Throws InputError when it cannot be read or is not sound.
FrameIndex read_frame_index(const std::filesystem::path& folder, const FrameIndexKind& kind);

/// Writes the folder's index, or lengthens the one there is. Throws InputError when the folder keeps
/// frames of another scene or of another rate.
FrameIndex keep_frame_index(const std::filesystem::path& folder, const FrameIndexKind& kind,
                            FrameIndex index);

}  // namespace pastoso::liquid_files
