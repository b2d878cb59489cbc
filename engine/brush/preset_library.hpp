// All presets that a painter can choose from: those of the program and the painter's own.
#pragma once

#include "brush/preset.hpp"
#include "core/message.hpp"

#include <filesystem>
#include <string>
#include <vector>

namespace pastoso::brush {

struct PresetLibrary {
    struct Entry {
        Preset preset;
        bool own = false;              ///< the painter's, not the program's
        std::filesystem::path file{};  ///< of the painter's own, empty otherwise
    };
    struct Fault {
        std::filesystem::path file;
        core::Message sentence;  ///< names the file, the place and the value
    };
    std::vector<Entry> entries;  ///< in the order of their names; no two have the same
    std::vector<Fault> faults;   ///< the painter's files that were left out
};

/// The bundled presets and those in `own_folder` (*.json, which need not exist). A preset of the
/// painter's takes the place of a bundled one of the same name. A file that is no preset, or names one
/// that another file has named, is left out and its fault told.
PresetLibrary load_presets(const std::filesystem::path& own_folder);

/// The entry of that name, upper and lower case alike; null when there is none.
const PresetLibrary::Entry* find_entry(const PresetLibrary& library, std::string_view name);

/// Where save_preset() puts a preset of that name: NAME.json in small letters. Different names may have
/// the same file.
std::filesystem::path preset_file(std::string_view name, const std::filesystem::path& own_folder);

/// Writes a preset of the painter's into the folder, which is made where it is missing. Returns the
/// file. Throws InputError when it cannot be written.
std::filesystem::path save_preset(const Preset& preset, const std::filesystem::path& own_folder);

/// Adds presets to the painter's own, all or none. One that is there already, the same to the number, is
/// left out; one whose name or file another one has gets a number behind its name. No two of `presets`
/// have one name. Returns the names under which they were added. Throws InputError when one cannot be
/// written.
std::vector<std::string> add_presets(const PresetLibrary& library, const std::vector<Preset>& presets,
                                     const std::filesystem::path& own_folder);

/// Gives a preset of the painter's another name, and the file of that name. Throws InputError, and
/// leaves all as it was, when the name is empty or taken, by a preset or by a file, and when the file
/// cannot be written.
void rename_preset(const PresetLibrary& library, const PresetLibrary::Entry& own,
                   const std::string& new_name);

/// Removes the file of a preset of the painter's. Throws InputError when it cannot be removed.
void delete_preset(const PresetLibrary::Entry& own);

}  // namespace pastoso::brush
