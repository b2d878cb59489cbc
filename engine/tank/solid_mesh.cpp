#include "tank/solid_mesh.hpp"

#include "core/check.hpp"
#include "liquid/flow/slices.hpp"
#include "liquid/surface/marching_cubes.hpp"

#include <algorithm>

#include <glm/common.hpp>

namespace pastoso::tank {
namespace {

/// Distances beyond so many spacings need not be exact: the surface is not near.
constexpr float kReach_spacings = 2.0F;

/// Points through the tank's walls and one beyond on every side, which is outside of all.
liquid::Lattice lattice_of(const TankScene& scene, int parts) {
    const auto cell_m = static_cast<float>(scene.cell_m);
    const float spacing_m = cell_m / static_cast<float>(parts);
    const int beyond = 1 + static_cast<int>(static_cast<float>(parts) * kSolidOverlap_cells + 1.0F);
    const glm::ivec3 points = scene.cells * parts + 2 * beyond;
    const float first = 0.5F - static_cast<float>(beyond);
    return {points.x, points.y, points.z, spacing_m, glm::vec3(first * spacing_m)};
}

}  // namespace

liquid::TriangleMesh solid_mesh(const TankScene& scene, int parts, core::ThreadPool& pool) {
    PASTOSO_CHECK(parts >= 1 && parts <= 8);
    check_tank(scene);
    if (scene.solids.empty()) return {};
    std::vector<ShapeDistance> solids(scene.solids.begin(), scene.solids.end());
    const liquid::Lattice lattice = lattice_of(scene, parts);
    const float reach_m = kReach_spacings * lattice.spacing_m;
    const glm::vec3 half_m = 0.5F * scene.size_m();
    const float overlap_m = kSolidOverlap_cells * static_cast<float>(scene.cell_m);
    liquid::SampledField depth_m(lattice);
    liquid::for_slices(pool, 0, lattice.nz, [&](int k) {
        for (int j = 0; j < lattice.ny; ++j)
            for (int i = 0; i < lattice.nx; ++i) {
                const glm::vec3 at_m = lattice.point_m(i, j, k);
                const glm::vec3 beyond_m = glm::abs(at_m - half_m) - half_m - overlap_m;
                const float out_m = std::max({beyond_m.x, beyond_m.y, beyond_m.z});
                float nearest_m = reach_m;
                for (const ShapeDistance& solid : solids)
                    if (out_m < reach_m) nearest_m = std::min(nearest_m, solid(at_m, reach_m));
                depth_m.at(i, j, k) = -std::max(nearest_m, out_m);
            }
    });
    return liquid::marching_cubes(depth_m.view(), 0.0F, pool);
}

}  // namespace pastoso::tank
