// Tools in one file, to be kept or given away (docs/brush-format.md): a zip archive with a preset of
// each and a manifest that names them.
#pragma once

#include "brush/preset.hpp"

#include <cstddef>
#include <filesystem>
#include <vector>

namespace pastoso::project {

inline constexpr std::size_t kMostBundledPresets = 1000;

/// Written aside. Throws InputError where that cannot be written. There are at most
/// kMostBundledPresets, no two of one name.
void write_brush_bundle(const std::vector<brush::Preset>& presets, const std::filesystem::path& file);

/// In the order of the manifest. Throws InputError that names the file, the entry and what is wrong
/// there: when it is no bundle, anything in it is malformed or missing, or two tools have one name.
std::vector<brush::Preset> read_brush_bundle(const std::filesystem::path& file);

}  // namespace pastoso::project
