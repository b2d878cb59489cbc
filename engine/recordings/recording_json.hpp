// Recordings in the program's own JSON form (docs/stroke-format.md).
#pragma once

#include "document/events.hpp"

#include <filesystem>
#include <string>
#include <string_view>

namespace pastoso::recordings {

inline constexpr int kStrokeFormatVersion = 16;

/// The recording as text, one event a line, in the oldest version from 3 on that can say it. Reading it
/// gives an equal recording.
std::string recording_to_json(const document::Recording& recording);

/// Whether what a recording names (paints, media) has to exist: to be replayed, it has to.
enum class Names { MustBeKnown, MayBeUnknown };

/// Reads the same. `name` stands for the file in errors. Throws InputError with the place in the file
/// for anything malformed, out of range, out of order, unknown, or written by a newer version.
document::Recording recording_from_json(std::string_view text, const std::string& name,
                                        Names names = Names::MustBeKnown);

/// recording_from_json() of a file. A relative path of a height image is taken from the file's folder.
document::Recording read_recording_json(const std::filesystem::path& path);

/// Writes aside and renames. Throws InputError when the place cannot be written.
void write_recording_json(const std::filesystem::path& path, const document::Recording& recording);

}  // namespace pastoso::recordings
