// A surface of the liquid as a file of triangles, in metres: .obj (y up), .ply and .stl (binary, z up),
// and .pbrt, a shape to be included in a scene (docs/mesh-export.md).
#pragma once

#include "files/keep_going.hpp"
#include "liquid/surface/triangle_mesh.hpp"

#include <filesystem>
#include <string>

namespace pastoso::liquid_files {

/// The three languages of PBRT's scenes: version 4, version 3, and versions 1 and 2.
enum class PbrtSyntax { V4, V3, V2 };

struct MeshExportOptions {
    std::string what = "milk";           ///< named in the file's comment
    PbrtSyntax syntax = PbrtSyntax::V4;  ///< of .pbrt files
};

/// Whether a file's name ends in .obj, .ply, .stl or .pbrt.
bool is_mesh_path(const std::filesystem::path& path);

/// Writes the mesh aside. Throws InputError when the name ends in none of the formats, when a number of
/// the mesh is not finite, and when the file cannot be written. An empty mesh makes a valid file without
/// triangles; of .pbrt, where an empty shape is an error, a comment.
files::ExportStatus export_mesh(const std::filesystem::path& path, const liquid::TriangleMesh& mesh,
                                const MeshExportOptions& options, const files::KeepGoing& keep_going);

}  // namespace pastoso::liquid_files
