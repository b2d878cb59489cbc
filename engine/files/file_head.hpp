// The first bytes of a file that may be too large for memory.
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>

namespace pastoso::files {

/// The first bytes of a file, fewer where it is shorter. Throws InputError when it cannot be read.
std::string file_head(const std::filesystem::path& path, std::size_t bytes);

/// Puts other bytes in the place of the first `replaced`. Throws InputError when that cannot be written;
/// the file is then as it was.
void replace_head(const std::filesystem::path& path, std::size_t replaced, std::string_view head);

}  // namespace pastoso::files
