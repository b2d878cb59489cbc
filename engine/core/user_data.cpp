#include "core/user_data.hpp"

#include <cstdlib>

namespace pastoso::core {
namespace {

/// The folder in the variable, empty when it is not set to an absolute path.
std::filesystem::path folder_in(const char* variable) {
    const char* value = std::getenv(variable);
    const std::filesystem::path folder = value == nullptr ? "" : value;
    return folder.is_absolute() ? folder : std::filesystem::path();
}

}  // namespace

std::filesystem::path user_data_path(const std::filesystem::path& relative) {
    if (const auto data = folder_in("XDG_DATA_HOME"); !data.empty()) return data / "pastoso" / relative;
    const auto home = folder_in("HOME");
    return home.empty() ? home : home / ".local" / "share" / "pastoso" / relative;
}

}  // namespace pastoso::core
