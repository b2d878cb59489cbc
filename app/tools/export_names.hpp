// The names of exported files: endings that follow the format, and what lies there already.
#pragma once

#include "tools/export_settings.hpp"

#include <filesystem>
#include <optional>

namespace pastoso::tools {

/// The path as the format has it: an ending of another format is exchanged, and one that is missing is
/// added. A folder's name has none.
std::filesystem::path with_ending(const std::filesystem::path& path, const ExportFormat& format);

/// The format of a form that a typed name asks for: `present` where its ending is that name's, otherwise
/// the first with that ending; none where the name ends in none of the form's.
std::optional<std::size_t> format_of(const std::filesystem::path& path, ExportForm form,
                                     std::size_t present);

/// Whether a file lies where the export of such a form would be put.
bool is_taken(const std::filesystem::path& path, ExportForm form);

/// The path, or with "-2", "-3" ... before its ending where it is taken.
std::filesystem::path untaken(const std::filesystem::path& path, ExportForm form);

}  // namespace pastoso::tools
