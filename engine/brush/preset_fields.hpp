// The numbers of a preset as a table: one home for their names in files, units, ranges and meanings.
// Reading, writing, the schema and the brush editor all go by it.
#pragma once

#include "brush/preset.hpp"

#include <span>
#include <string_view>

namespace pastoso::brush {

struct PresetField {
    std::string_view section;  ///< of the file, for example "tip"
    std::string_view key;      ///< within the section, for example "width"
    std::string_view unit;     ///< "mm", "ms", ...; empty for a pure number
    double low, high;          ///< both allowed
    bool whole;                ///< takes whole numbers only
    std::string_view meaning;  ///< for painters, a line
    int since;                 ///< the version of the format that has it first; before, the default
    double (*get)(const Preset&);
    void (*set)(Preset&, double);
};

/// All of them, in the order of the file.
std::span<const PresetField> preset_fields();

/// Whether tools of this kind have that field; the others have not.
bool applies_to(const PresetField& field, ToolKind kind);

/// The preset with that number changed, within its range, and whole where the field is. Others that
/// would contradict it go along: a point is no longer than the hairs, and drops are large enough for
/// what falls in a second.
Preset with_number(Preset preset, const PresetField& field, double value);

/// The preset with all of its numbers within their ranges: a tip that is held much wider than its preset
/// has hairs that are longer than any preset may say.
Preset within_ranges(Preset preset);

/// More drops than a picture shows would only take time.
inline constexpr double kMostDrops_per_s = 1e5;

/// The sections that hold numbers, in the order of the file.
inline constexpr std::string_view kPresetSections[] = {"tip",    "flex",     "paint", "exchange",
                                                       "stroke", "droplets", "air"};

}  // namespace pastoso::brush
