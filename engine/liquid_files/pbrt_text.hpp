// What PBRT's files consist of, in its three languages.
#pragma once

#include "files/piece_writer.hpp"
#include "liquid_files/mesh_export.hpp"

#include <initializer_list>
#include <string>

namespace pastoso::liquid_files {

/// "1 2.5 3": the shortest numbers that read as the same floats.
std::string pbrt_numbers(std::initializer_list<float> numbers);

/// Writes a mesh as the shape "trianglemesh", aside. The mesh is sound (mesh_export.hpp).
files::ExportStatus write_pbrt_shape(const std::filesystem::path& path, const liquid::TriangleMesh& mesh,
                                     const std::string& what, PbrtSyntax syntax,
                                     const files::KeepGoing& keep_going);

}  // namespace pastoso::liquid_files
