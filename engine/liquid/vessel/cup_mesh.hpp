// The cup and the tea in it as triangles, one mesh for each pair of neighbours that light crosses
// between.
#pragma once

#include "liquid/surface/triangle_mesh.hpp"
#include "liquid/vessel/cup.hpp"

namespace pastoso::liquid {

/// Together they enclose the glass and the tea without overlap: no surface stands twice. Vertices at
/// edges are kept twice, with the normals of either side.
struct CupMeshes {
    TriangleMesh glass_air;  ///< the glass where no tea touches it; normals out of the glass
    TriangleMesh tea_glass;  ///< the tea's floor and wall; normals out of the tea
    TriangleMesh tea_air;    ///< the tea's level; normals up
};

/// `segments` >= 3 around the axis. The wall is as thick as `wall_m` at every height. The cup's floor
/// lies above its foot, the level between floor and rim.
CupMeshes cup_meshes(const Cup& cup, int segments = 128);

}  // namespace pastoso::liquid
