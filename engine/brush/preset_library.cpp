#include "brush/preset_library.hpp"

#include "core/error.hpp"
#include "core/looking.hpp"
#include "core/text.hpp"
#include "core/text_file.hpp"

#include <algorithm>
#include <cctype>
#include <system_error>

namespace pastoso::brush {
namespace {

using Entry = PresetLibrary::Entry;

auto find_name(auto& entries, std::string_view name) {
    return std::find_if(entries.begin(), entries.end(),
                        [lower = core::lower_case(name)](const Entry& entry) {
                            return core::lower_case(entry.preset.name) == lower;
                        });
}

void add_own(Preset preset, const std::filesystem::path& file, std::vector<Entry>& entries) {
    const auto same = find_name(entries, preset.name);
    if (same == entries.end()) {
        entries.push_back({std::move(preset), true, file});
    } else if (!same->own) {
        *same = {std::move(preset), true, file};
    } else {
        throw core::InputError("%1: name is \"%2\", which another preset of yours has already.",
                               file.string(), preset.name);
    }
}

/// Letters and digits in small letters, everything else as single dashes.
std::string file_name_of(const std::string& preset_name) {
    std::string name;
    for (const char c : core::lower_case(preset_name)) {
        if (std::isalnum(static_cast<unsigned char>(c)) != 0)
            name += c;
        else if (!name.empty() && name.back() != '-')
            name += '-';
    }
    if (!name.empty() && name.back() == '-') name.pop_back();
    return (name.empty() ? "preset" : name) + ".json";
}

void remove_file(const std::filesystem::path& file) {
    std::error_code failure;
    if (!std::filesystem::remove(file, failure) && failure)
        throw core::InputError("%1: cannot be removed (%2).", file.string(), failure.message());
}

/// Its own name, or the first that is free of those with a number behind it.
Preset with_free_name(const Preset& preset, const PresetLibrary& library,
                      const std::filesystem::path& own_folder) {
    const auto is_free = [&](const std::string& name) {
        return find_entry(library, name) == nullptr && !core::is_there(preset_file(name, own_folder));
    };
    Preset named = preset;
    for (int number = 2; !is_free(named.name); ++number)
        named.name = preset.name + " " + std::to_string(number);
    return named;
}

}  // namespace

PresetLibrary load_presets(const std::filesystem::path& own_folder) {
    PresetLibrary library;
    for (const Preset& preset : bundled_presets())
        library.entries.push_back({preset, false});
    for (const auto& file : core::files_in(own_folder, ".json")) {
        try {
            add_own(parse_preset(core::read_text_file(file), file.string()), file, library.entries);
        } catch (const core::InputError& fault) {
            library.faults.push_back({file, fault.message()});
        }
    }
    std::sort(library.entries.begin(), library.entries.end(),
              [](const Entry& a, const Entry& b) { return a.preset.name < b.preset.name; });
    return library;
}

const Entry* find_entry(const PresetLibrary& library, std::string_view name) {
    const auto found = find_name(library.entries, name);
    return found == library.entries.end() ? nullptr : &*found;
}

std::filesystem::path preset_file(std::string_view name, const std::filesystem::path& own_folder) {
    return own_folder / file_name_of(std::string(name));
}

std::filesystem::path save_preset(const Preset& preset, const std::filesystem::path& own_folder) {
    std::error_code failure;
    std::filesystem::create_directories(own_folder, failure);
    if (failure) {
        throw core::InputError("%1: this folder cannot be made (%2).", own_folder.string(),
                               failure.message());
    }
    const std::filesystem::path file = preset_file(preset.name, own_folder);
    core::write_text_file(file, preset_to_json(preset));
    return file;
}

std::vector<std::string> add_presets(const PresetLibrary& library, const std::vector<Preset>& presets,
                                     const std::filesystem::path& own_folder) {
    std::vector<std::string> added;
    std::vector<std::filesystem::path> written;
    try {
        for (const Preset& preset : presets) {
            const Entry* same = find_entry(library, preset.name);
            if (same != nullptr && same->preset == preset) continue;
            const Preset named = with_free_name(preset, library, own_folder);
            written.push_back(save_preset(named, own_folder));
            added.push_back(named.name);
        }
    } catch (const core::InputError&) {
        for (const auto& file : written)
            remove_file(file);
        throw;
    }
    return added;
}

void rename_preset(const PresetLibrary& library, const Entry& own, const std::string& new_name) {
    if (new_name.empty()) throw core::InputError("A brush needs a name.");
    const Entry* same = find_entry(library, new_name);
    if (same != nullptr && same->file != own.file)
        throw core::InputError("There is already a brush \"%1\".", same->preset.name);
    const std::filesystem::path folder = own.file.parent_path(), old_file = own.file;
    const std::filesystem::path file = preset_file(new_name, folder);
    if (file != old_file && core::is_there(file))
        throw core::InputError("There is already a file %1.", file.string());
    Preset renamed = own.preset;
    renamed.name = new_name;
    save_preset(renamed, folder);
    if (file != old_file) remove_file(old_file);
}

void delete_preset(const Entry& own) {
    remove_file(own.file);
}

}  // namespace pastoso::brush
