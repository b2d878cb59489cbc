// Relief as a file of triangles: .stl (binary), .ply (binary) or .obj.
#pragma once

#include "files/triangle_file.hpp"
#include "recordings/export_bands.hpp"
#include "recordings/relief_mesh.hpp"

#include <filesystem>

namespace pastoso::recordings {

/// Whether a file's name ends in .stl, .ply or .obj.
bool is_relief_path(const std::filesystem::path& path);

/// Writes the solid aside, in millimetres. Throws InputError when the name ends in none of the formats
/// and when the file cannot be written.
files::ExportStatus export_relief(const std::filesystem::path& path, const Relief& relief,
                                  const files::KeepGoing& keep_going);

}  // namespace pastoso::recordings
