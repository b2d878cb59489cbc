// The solids in a tank as a surface of triangles, to be drawn.
#pragma once

#include "core/thread_pool.hpp"
#include "liquid/surface/triangle_mesh.hpp"
#include "tank/tank_scene.hpp"

namespace pastoso::tank {

/// How far solids that stand at a wall reach beyond it, in cells: so that no gap is seen between them.
inline constexpr float kSolidOverlap_cells = 0.25F;

/// The zero of the solids' distance within the tank, closed, with normals; empty without solids. Sampled
/// `parts` times (1 to 8) along a cell: edges are cut off by about that. Throws InputError like
/// check_tank().
liquid::TriangleMesh solid_mesh(const TankScene& scene, int parts, core::ThreadPool& pool);

}  // namespace pastoso::tank
