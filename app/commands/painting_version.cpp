#include "commands/painting_version.hpp"

#include "core/looking.hpp"

#include <algorithm>
#include <charconv>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace pastoso::commands {
namespace {

constexpr std::size_t kDigits = 3;
/// More is a date, or the number of a photograph.
constexpr std::size_t kMostDigits = 4;

struct Version {
    std::string_view name;  ///< without the number
    std::optional<std::uint32_t> number;
};

/// The stem of a file's name, taken apart.
Version version_of(std::string_view stem) {
    const std::size_t line = stem.rfind('_');
    if (line == std::string_view::npos || line == 0) return {stem, {}};
    const std::string_view digits = stem.substr(line + 1);
    if (digits.empty() || digits.size() > kMostDigits) return {stem, {}};
    std::uint32_t number = 0;
    const auto [end, error] = std::from_chars(digits.begin(), digits.end(), number);
    if (error != std::errc() || end != digits.end()) return {stem, {}};
    return {stem.substr(0, line), number};
}

/// The highest that a file of this name has; 0 where none has one.
std::uint32_t highest(const std::filesystem::path& folder, std::string_view name,
                      const std::filesystem::path& extension) {
    std::uint32_t found = 0;
    for (const std::filesystem::path& entry : core::entries_of(folder)) {
        const std::string stem = entry.stem().string();
        const Version version = version_of(stem);
        if (version.name == name && entry.extension() == extension)
            found = std::max(found, version.number.value_or(0));
    }
    return found;
}

}  // namespace

std::filesystem::path next_version(const std::filesystem::path& painting) {
    const std::filesystem::path folder = core::absolute_path(painting).parent_path();
    const std::string stem = painting.stem().string();
    const Version version = version_of(stem);
    const std::uint32_t before =
        std::max(version.number.value_or(0), highest(folder, version.name, painting.extension()));
    std::string number = std::to_string(before + 1);
    number.insert(0, kDigits - std::min(kDigits, number.size()), '0');
    std::filesystem::path name = std::string(version.name) + "_" + number;
    name += painting.extension();
    return folder / name;
}

}  // namespace pastoso::commands
