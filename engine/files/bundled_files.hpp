// Files that come with the program, given by their names alone.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace pastoso::files {

/// The names of the .json files in a folder of resources, in alphabetical order.
std::vector<std::string> bundled_names(const std::string& folder);

/// The path of `path_or_name`: what has an ending, a folder or exists is a path, all else the name of a
/// scene in that folder. Throws InputError that lists them when there is none of that name.
std::filesystem::path scene_path(const std::string& path_or_name, const std::string& folder);

}  // namespace pastoso::files
