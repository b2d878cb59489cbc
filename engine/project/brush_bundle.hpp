// Tools in one file, to be kept or given away (docs/brush-format.md): a zip archive with a preset of
// each and a manifest that names them and their tags.
#pragma once

#include "brush/preset.hpp"

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

namespace pastoso::project {

inline constexpr std::size_t kMostBundledPresets = 1000;

/// A painter's own word for some tools.
struct BundledTag {
    std::string name;                ///< not blank, and no other tag's
    std::vector<std::string> tools;  ///< by name; some may ship with the program
    friend bool operator==(const BundledTag&, const BundledTag&) = default;
};

struct BrushBundle {
    std::vector<brush::Preset> presets;  ///< at most kMostBundledPresets, no two of one name
    std::vector<BundledTag> tags{};      ///< none in bundles of version 1
    friend bool operator==(const BrushBundle&, const BrushBundle&) = default;
};

/// Written aside, in the oldest version that can say it. Throws InputError where that cannot be written.
void write_brush_bundle(const BrushBundle& bundle, const std::filesystem::path& file);

/// In the order of the manifest. Throws InputError that names the file, the entry and what is wrong
/// there: when it is no bundle, anything in it is malformed or missing, or two tools or tags have one
/// name.
BrushBundle read_brush_bundle(const std::filesystem::path& file);

}  // namespace pastoso::project
