// The paintings that were opened or saved last.
#pragma once

#include <filesystem>
#include <vector>

namespace pastoso::commands {

inline constexpr std::size_t kMostRecent = 10;

/// Those that are still there, the latest first. None where nothing is known.
std::vector<std::filesystem::path> recent_paintings();

/// The same with those that are not there any more: a drive may come back.
std::vector<std::filesystem::path> known_paintings();

/// Takes a painting from the list. Its file stays.
void forget_painting(const std::filesystem::path& path);

/// Puts a painting first. Where the list cannot be kept, it is not.
void remember_painting(const std::filesystem::path& path);

}  // namespace pastoso::commands
