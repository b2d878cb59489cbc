// Surfaces of triangles out of files, in metres: .obj (y up) and .stl (binary or text, z up), as
// mesh_export.hpp writes them and other programs do (docs/mesh-export.md).
#pragma once

#include "liquid/surface/triangle_mesh.hpp"

#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>

namespace pastoso::liquid_files {

inline constexpr std::size_t kMostMeshTriangles = 10'000'000, kMostMeshVertices = 10'000'000;

/// Reads a mesh, which may be empty and need not be closed. Throws InputError that names the file, the
/// line or byte in it and the value when the file cannot be read, is neither of them, ends too early,
/// names vertices that are not there, holds a number that is not finite, or more than the limits above.
liquid::TriangleMesh import_mesh(const std::filesystem::path& path);

/// What is read of .obj: `v`, `vn` and `f`, whose corners are positions or positions with texture and
/// normal ("1", "1/2", "1//3", "1/2/3"), counted from 1 or, backwards, from -1; faces of more corners
/// are cut into triangles from their first one. A vertex stands before the faces that name it. Normals
/// are kept when there is one for each position, with its number, as in files of ours. The rest
/// (textures, groups, materials, lines) is passed over. From y up to z up: (x, y, z) becomes (x, -z, y).
liquid::TriangleMesh mesh_from_obj(std::string_view text, const std::string& name);

/// A file of just the size that its count of triangles asks for is binary, any other that begins with
/// "solid" a text. Corners at the same place become one vertex; triangles two of whose corners are the
/// same are left out, as are normals.
liquid::TriangleMesh mesh_from_stl(std::string_view bytes, const std::string& name);

}  // namespace pastoso::liquid_files
