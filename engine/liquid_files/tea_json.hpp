// Milk tea scenes as JSON (docs/tea-format.md).
#pragma once

#include "liquid/tea/tea_settings.hpp"

#include <string>
#include <string_view>
#include <vector>

namespace pastoso::liquid_files {

inline constexpr int kTeaFormatVersion = 1;

/// Reads settings; what the file does not say is as usual. Throws InputError "FILE, milk_m3: MESSAGE"
/// for whatever docs/tea-format.md does not allow.
liquid::TeaSettings tea_from_json(std::string_view text, const std::string& name);

/// The names of the scenes that come with the program, in alphabetical order.
std::vector<std::string> bundled_tea_names();

/// The same of a file, or of a scene that comes with the program when `path_or_name` is a name without a
/// folder and an ending. Throws InputError that lists the names when there is none of that name.
liquid::TeaSettings read_tea(const std::string& path_or_name);

/// Steps of a frame at that many frames a second: at most as long as the settings say, and a whole
/// number of them.
int steps_per_frame(const liquid::TeaSettings& settings, double fps);

/// The settings with steps of that length.
liquid::TeaSettings stepped_for(liquid::TeaSettings settings, double fps);

/// All of the settings; tea_from_json() gives them back exactly.
std::string tea_to_json(const liquid::TeaSettings& settings);

}  // namespace pastoso::liquid_files
