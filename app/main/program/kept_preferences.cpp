#include "main/program/kept_preferences.hpp"

#include "core/error.hpp"
#include "core/user_data.hpp"

namespace pastoso::main {

std::filesystem::path preferences_file() {
    return core::user_config_path("preferences.json");
}

KeptPreferences kept_preferences() {
    try {
        return {tools::read_preferences(preferences_file()), {}};
    } catch (const core::InputError& error) {
        return {{}, error.what()};
    }
}

}  // namespace pastoso::main
