#include "cli/brush_choice.hpp"

#include "brush/preset_library.hpp"
#include "core/error.hpp"
#include "core/text_file.hpp"
#include "core/user_data.hpp"

#include <filesystem>

namespace pastoso::cli {
namespace {

document::TakeBrush with_definition(const brush::Preset& preset) {
    return {.preset = preset.name, .definition = brush::preset_to_json(preset)};
}

/// An unknown name may be that of a file that could not be read.
std::string with_faults(std::string message, const std::vector<brush::PresetLibrary::Fault>& faults) {
    for (const auto& fault : faults)
        message += " Left out: " + fault.sentence.text();
    return message;
}

}  // namespace

document::TakeBrush chosen_brush(const std::string& name) {
    if (std::filesystem::path(name).extension() == ".json")
        return with_definition(brush::parse_preset(core::read_text_file(name), name));
    const auto library = brush::load_presets(core::user_data_path("brushes"));
    const auto* entry = brush::find_entry(library, name);
    if (entry != nullptr && entry->own) return with_definition(entry->preset);
    try {
        return {.preset = brush::find_preset(name).name};
    } catch (const core::InputError& unknown) {
        throw core::InputError(core::Message::verbatim(with_faults(unknown.what(), library.faults)));
    }
}

}  // namespace pastoso::cli
