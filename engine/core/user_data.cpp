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

/// Below the folder in the variable, or that one of the user's home.
std::filesystem::path path_below(const char* variable, const std::filesystem::path& in_home,
                                 const std::filesystem::path& relative) {
    if (const auto folder = folder_in(variable); !folder.empty()) return folder / "pastoso" / relative;
    const auto home = folder_in("HOME");
    return home.empty() ? home : home / in_home / "pastoso" / relative;
}

}  // namespace

std::filesystem::path user_data_path(const std::filesystem::path& relative) {
    return path_below("XDG_DATA_HOME", ".local/share", relative);
}

std::filesystem::path user_config_path(const std::filesystem::path& relative) {
    return path_below("XDG_CONFIG_HOME", ".config", relative);
}

std::filesystem::path user_state_path(const std::filesystem::path& relative) {
    return path_below("XDG_STATE_HOME", ".local/state", relative);
}

}  // namespace pastoso::core
