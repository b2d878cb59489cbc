// Reads files of triangles as another program does that knows their formats.
#pragma once

#include "liquid/surface/triangle_mesh.hpp"

#include <string>

namespace pastoso::files {

/// Binary, with or without normals. The file's text, as in all of them.
liquid::TriangleMesh read_ply(const std::string& file);

/// Binary: three vertices of their own for every triangle, whose normals are that of the facet.
liquid::TriangleMesh read_stl(const std::string& file);

/// As it lies in the file, y up where the writer turned it so.
liquid::TriangleMesh read_obj(const std::string& file);

}  // namespace pastoso::files
