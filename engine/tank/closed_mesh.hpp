// What a mesh must be to enclose something.
#pragma once

#include "liquid/surface/triangle_mesh.hpp"

namespace pastoso::tank {

/// Throws InputError for a mesh without triangles, with a position that is not finite or farther than
/// kFarthest_m, with a triangle that names a vertex that is not there, or with an edge that is not
/// shared by exactly two triangles that run along it in opposite directions.
void check_closed(const liquid::TriangleMesh& mesh);

}  // namespace pastoso::tank
