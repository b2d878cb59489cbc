// What stands at a path, asked without exceptions: what may not be looked at (a loop of links, a folder
// without permission, a name too long) counts as not there, and whoever opens it says why.
#pragma once

#include <filesystem>
#include <vector>

namespace pastoso::core {

bool is_there(const std::filesystem::path& path) noexcept;
bool is_folder(const std::filesystem::path& path) noexcept;
bool is_regular_file(const std::filesystem::path& path) noexcept;

/// What a folder holds, in no order; nothing where it cannot be read, and what could be read where its
/// rest cannot.
std::vector<std::filesystem::path> entries_of(const std::filesystem::path& folder);

/// The path from the root on; `path` itself where nobody can tell which folder the program is in.
std::filesystem::path absolute_path(const std::filesystem::path& path);

}  // namespace pastoso::core
