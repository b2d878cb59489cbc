// The painter's preferences as they are kept: read once, before there is a window that could tell what
// is wrong with them.
#pragma once

#include "core/message.hpp"
#include "tools/preferences.hpp"

#include <filesystem>

namespace pastoso::main {

struct KeptPreferences {
    tools::Preferences values;  ///< those at first where the file cannot be read
    core::Message fault;        ///< why it cannot; empty where it can
};

/// Where they are kept; empty where there is no home.
std::filesystem::path preferences_file();

KeptPreferences kept_preferences();

}  // namespace pastoso::main
