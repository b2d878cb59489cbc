#include "main/program/kept_preferences.hpp"

#include "core/fault.hpp"
#include "core/user_data.hpp"

namespace pastoso::main {

std::filesystem::path preferences_file() {
    return core::user_config_path("preferences.json");
}

KeptPreferences kept_preferences() {
    KeptPreferences kept;
    kept.fault = core::fault_of([&] { kept.values = tools::read_preferences(preferences_file()); });
    return kept;
}

}  // namespace pastoso::main
