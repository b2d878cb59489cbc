// The first bytes of a file that may be too large for memory.
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>

namespace pastoso::files {

/// The first bytes of a file, fewer where it is shorter. Throws InputError when it cannot be read.
std::string file_head(const std::filesystem::path& path, std::size_t bytes);

}  // namespace pastoso::files
