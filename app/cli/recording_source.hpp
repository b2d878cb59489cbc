// From the command line to the recording that is to be replayed.
#pragma once

#include "cli/options.hpp"
#include "document/events.hpp"

namespace pastoso::cli {

inline constexpr const char* kDefaultBrush = "Flat bristle 20";
inline constexpr const char* kDefaultMedium = "heavy-body oil";

/// Reads options.strokes, JSON when its name ends in .json, four-column text otherwise, and applies what
/// the command line says. Throws InputError for a bad recording and UsageError for options that do not
/// apply to the kind of recording.
document::Recording load_recording(const ReplayOptions& options);

/// Says on the standard error stream that its strokes were painted with another arithmetic, where they
/// were.
void tell_arithmetic(const std::string& path, const document::Recording& recording);

/// Whether the file's name ends in .json.
bool is_json_recording(const std::string& path);

}  // namespace pastoso::cli
