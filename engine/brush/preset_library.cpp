#include "brush/preset_library.hpp"

#include "core/error.hpp"
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

void add_own(Preset preset, const std::string& file, std::vector<Entry>& entries) {
    const auto same = find_name(entries, preset.name);
    if (same == entries.end()) {
        entries.push_back({std::move(preset), true});
    } else if (!same->own) {
        *same = {std::move(preset), true};
    } else {
        throw core::InputError(file + ": name is \"" + preset.name +
                               "\", which another preset of yours has already.");
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

}  // namespace

PresetLibrary load_presets(const std::filesystem::path& own_folder) {
    PresetLibrary library;
    for (const Preset& preset : bundled_presets())
        library.entries.push_back({preset, false});
    for (const auto& file : core::files_in(own_folder, ".json")) {
        try {
            add_own(parse_preset(core::read_text_file(file), file.string()), file.string(),
                    library.entries);
        } catch (const core::InputError& fault) {
            library.faults.emplace_back(fault.what());
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

std::filesystem::path save_preset(const Preset& preset, const std::filesystem::path& own_folder) {
    std::error_code failure;
    std::filesystem::create_directories(own_folder, failure);
    if (failure) {
        throw core::InputError(own_folder.string() + ": this folder cannot be made (" +
                               failure.message() + ").");
    }
    const std::filesystem::path file = own_folder / file_name_of(preset.name);
    core::write_text_file(file, preset_to_json(preset));
    return file;
}

}  // namespace pastoso::brush
