// Numbered versions of a painting, in files beside one another.
#pragma once

#include <filesystem>

namespace pastoso::commands {

/// "rose_001.pastoso" for "rose.pastoso", "rose_008.pastoso" for "rose_002.pastoso" where "rose_007" is
/// the highest that stands beside it: the file in which the painting goes on, at which nothing stands.
std::filesystem::path next_version(const std::filesystem::path& painting);

}  // namespace pastoso::commands
