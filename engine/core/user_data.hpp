// Where the user's own data lies: what adds to the program's resources.
#pragma once

#include <filesystem>

namespace pastoso::core {

/// The path of something of the user's, for example user_data_path("pigments"), whether it exists or
/// not: below $XDG_DATA_HOME/pastoso, or $HOME/.local/share/pastoso where that is not set to an absolute
/// path (XDG Base Directory Specification 0.8). Empty where there is no home either.
std::filesystem::path user_data_path(const std::filesystem::path& relative);

/// The same for how the user has set the program up: below $XDG_CONFIG_HOME/pastoso or
/// $HOME/.config/pastoso.
std::filesystem::path user_config_path(const std::filesystem::path& relative);

/// The same for what a run of the program leaves to the next one: below $XDG_STATE_HOME/pastoso or
/// $HOME/.local/state/pastoso.
std::filesystem::path user_state_path(const std::filesystem::path& relative);

}  // namespace pastoso::core
