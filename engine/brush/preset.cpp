#include "brush/preset.hpp"

#include "brush/preset_names.hpp"
#include "core/error.hpp"
#include "core/resources.hpp"
#include "core/text.hpp"
#include "core/text_file.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace pastoso::brush {
namespace {

constexpr int kFewestBristles = 30;
constexpr int kMostBristles = 250;
/// Tips that are wider than this have more, as many as it takes for the outline not to become a row of
/// large spots.
constexpr double kWide_mm = 60.0;

/// The tool that a single word means.
constexpr std::pair<std::string_view, std::string_view> kShortNames[] = {{"flat", "Flat bristle 20"},
                                                                         {"round", "Round sable 9"},
                                                                         {"filbert", "Filbert 14"},
                                                                         {"fan", "Fan 26"},
                                                                         {"mop", "Mop 30"},
                                                                         {"rigger", "Rigger 2"},
                                                                         {"blender", "Blender 28"},
                                                                         {"knife", "Palette knife 17"},
                                                                         {"scraper", "Scraper 30"},
                                                                         {"comb", "Comb 25"},
                                                                         {"rag", "Rag 35"},
                                                                         {"eraser", "Eraser 15"},
                                                                         {"blot", "Blotting pad 40"},
                                                                         {"finger", "Fingertip 12"},
                                                                         {"dropper", "Dropper"},
                                                                         {"spray", "Spray can 35"},
                                                                         {"airbrush", "Airbrush 7"},
                                                                         {"spatter", "Spatter 45"},
                                                                         {"thinner", "Thinner brush 16"},
                                                                         {"blow", "Straw 8"},
                                                                         {"nib", "Calligraphy nib 3"},
                                                                         {"charcoal", "Charcoal 8"},
                                                                         {"pastel", "Oil pastel 10"},
                                                                         {"roller", "Roller 50"},
                                                                         {"sponge", "Sponge 45"},
                                                                         {"squeegee", "Squeegee 120"}};

std::vector<Preset> read_bundled_presets() {
    std::vector<Preset> presets;
    for (const auto& file : core::files_in(core::resource_path("brushes"), ".json")) {
        presets.push_back(parse_preset(core::read_text_file(file), file.filename().string()));
    }
    return presets;
}

std::string list_of_names() {
    std::string names;
    for (const Preset& preset : bundled_presets()) {
        names += (names.empty() ? "\"" : ", \"") + preset.name + "\"";
    }
    return names;
}

}  // namespace

std::string_view name_of(TipShape shape) {
    return word_for(shape, kShapeNames);
}

bool is_row(TipShape shape) {
    return shape == TipShape::Knife || shape == TipShape::Comb || shape == TipShape::Nib;
}

const std::vector<Preset>& bundled_presets() {
    static const std::vector<Preset> presets = read_bundled_presets();
    return presets;
}

const Preset& find_preset(std::string_view name) {
    const std::string lower = core::lower_case(name);
    for (const Preset& preset : bundled_presets()) {
        if (core::lower_case(preset.name) == lower) return preset;
    }
    for (const auto& [word, preset_name] : kShortNames) {
        if (word == lower) return find_preset(preset_name);
    }
    throw core::InputError("There is no brush \"%1\"; the brushes are %2.", name, list_of_names());
}

Preset resized(const Preset& preset, double width_mm) {
    Preset result = preset;
    if (width_mm <= 0.0) return result;
    const double scale = width_mm / preset.tip.width_mm;
    result.tip.width_mm *= scale;
    result.tip.thickness_mm *= scale;
    result.tip.length_mm *= scale;
    result.tip.point_mm *= scale;
    result.tip.pores_mm *= scale;
    const int count = preset.tip.bristles;
    const bool row = is_row(preset.tip.shape), rolls = preset.tip.girth_mm > 0.0;
    const auto scaled = static_cast<int>(std::lround(count * (row || rolls ? scale : scale * scale)));
    if (row) result.paint.leave = std::min(1.0, scale * preset.paint.leave);
    const double wide = std::max(1.0, result.tip.width_mm / kWide_mm);
    const auto most = static_cast<int>(std::lround(kMostBristles * wide));
    result.tip.bristles = std::clamp(scaled, std::min(count, kFewestBristles), std::max(count, most));
    return result;
}

}  // namespace pastoso::brush
