// Milk tea scenes as JSON (docs/tea-format.md).
#pragma once

#include "liquid/tea_settings.hpp"

#include <filesystem>
#include <string>
#include <string_view>

namespace pastoso::io {

inline constexpr int kTeaFormatVersion = 1;

/// Reads settings; what the file does not say is as usual. Throws InputError "FILE, milk_m3: MESSAGE"
/// for whatever docs/tea-format.md does not allow.
liquid::TeaSettings tea_from_json(std::string_view text, const std::string& name);

/// The same of a file.
liquid::TeaSettings read_tea(const std::filesystem::path& path);

/// All of the settings; tea_from_json() gives them back exactly.
std::string tea_to_json(const liquid::TeaSettings& settings);

}  // namespace pastoso::io
