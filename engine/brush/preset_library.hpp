// All presets that a painter can choose from: those of the program and the painter's own.
#pragma once

#include "brush/preset.hpp"

#include <filesystem>
#include <string>
#include <vector>

namespace pastoso::brush {

struct PresetLibrary {
    struct Entry {
        Preset preset;
        bool own = false;  ///< the painter's, not the program's
    };
    std::vector<Entry> entries;       ///< in the order of their names; no two have the same
    std::vector<std::string> faults;  ///< a sentence for each file of the painter's that was left out
};

/// The bundled presets and those in `own_folder` (*.json, which need not exist). A preset of the
/// painter's takes the place of a bundled one of the same name. A file that is no preset, or names one
/// that another file has named, is left out and its fault told.
PresetLibrary load_presets(const std::filesystem::path& own_folder);

/// The entry of that name, upper and lower case alike; null when there is none.
const PresetLibrary::Entry* find_entry(const PresetLibrary& library, std::string_view name);

/// Writes a preset of the painter's into the folder, which is made where it is missing, as NAME.json in
/// small letters. Returns the file. Throws InputError when it cannot be written.
std::filesystem::path save_preset(const Preset& preset, const std::filesystem::path& own_folder);

}  // namespace pastoso::brush
