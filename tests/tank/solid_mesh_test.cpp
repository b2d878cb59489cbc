#include "tank/solid_mesh.hpp"

#include "core/error.hpp"
#include "tank_cases.hpp"

#include <cmath>
#include <numbers>

#include <glm/common.hpp>
#include <gtest/gtest.h>

namespace pastoso::tank {
namespace {

/// A tank of 0.3 m, 0.2 m and 0.25 m, in cells of 1 cm.
TankScene tank_with(std::vector<Shape> solids) {
    TankScene scene;
    scene.cells = {30, 20, 25};
    scene.cell_m = 0.01;
    scene.solids = std::move(solids);
    return scene;
}

double mesh_m3(const TankScene& scene, int parts) {
    core::ThreadPool pool(2);
    return liquid::volume_m3(solid_mesh(scene, parts, pool));
}

TEST(SolidMesh, OfABallHoldsItsVolumeToSecondOrder) {
    const TankScene scene = tank_with({{Sphere{{0.151F, 0.093F, 0.117F}, 0.06F}}});
    const double exact = 4.0 / 3.0 * std::numbers::pi * std::pow(0.06, 3);
    const double coarse = mesh_m3(scene, 1) / exact - 1.0, fine = mesh_m3(scene, 4) / exact - 1.0;
    // A chord of h sags by h^2 / 8R: three times that for the area, h = R / 24.
    EXPECT_LT(std::abs(fine), 2e-3);
    EXPECT_NEAR(std::log2(coarse / fine) / 2.0, 2.0, 0.3) << coarse << " and " << fine;
}

TEST(SolidMesh, IsCutALittleBeyondTheWalls) {
    // Ends beyond the walls on both sides and under the floor, and stands up to 8.2 cm.
    const TankScene scene = tank_with({{Block{{0.102F, -0.5F, -0.5F}, {0.153F, 0.5F, 0.082F}}}});
    core::ThreadPool pool(2);
    const liquid::TriangleMesh mesh = solid_mesh(scene, 4, pool);
    glm::vec3 low(1.0F), high(-1.0F);
    for (const glm::vec3& position : mesh.positions_m) {
        low = glm::min(low, position);
        high = glm::max(high, position);
    }
    const float overlap_m = 0.01F * kSolidOverlap_cells;
    // The cut lies on faces of the lattice, where distances are linear: rounding alone.
    const glm::vec3 low_m(0.102F, -overlap_m, -overlap_m), high_m(0.153F, 0.2F + overlap_m, 0.082F);
    for (int axis = 0; axis < 3; ++axis) {
        EXPECT_NEAR(low[axis], low_m[axis], 1e-5F);
        EXPECT_NEAR(high[axis], high_m[axis], 1e-5F);
    }
    const glm::dvec3 size = high_m - low_m;
    // Edges are cut off by half a square of the spacing at most.
    const double cut = 0.5 * std::pow(0.0025, 2) * 4.0 * (size.x + size.y + size.z);
    const double exact = size.x * size.y * size.z;
    EXPECT_LE(liquid::volume_m3(mesh), exact * (1.0 + 1e-4));
    EXPECT_GE(liquid::volume_m3(mesh), exact - cut);
}

TEST(SolidMesh, HoldsAllSolidsOnce) {
    const Shape left{Sphere{{0.08F, 0.1F, 0.1F}, 0.05F}}, right{Sphere{{0.22F, 0.1F, 0.1F}, 0.05F}};
    const double one = mesh_m3(tank_with({left}), 2);
    // The same points of the lattice around both, but for rounding.
    EXPECT_NEAR(mesh_m3(tank_with({left, right}), 2), 2.0 * one, 1e-5 * one);
    EXPECT_EQ(mesh_m3(tank_with({left, left}), 2), one);
}

TEST(SolidMesh, IsEmptyWithoutSolidsOrWhereTheyLieOutside) {
    core::ThreadPool pool(1);
    EXPECT_TRUE(solid_mesh(tank_with({}), 2, pool).empty());
    EXPECT_TRUE(solid_mesh(tank_with({{Sphere{{0.6F, 0.1F, 0.1F}, 0.05F}}}), 2, pool).empty());
    EXPECT_THROW(solid_mesh(tank_with({{Sphere{{0.6F, 0.1F, 0.1F}, -1.0F}}}), 2, pool),
                 core::InputError);
}

TEST(SolidMesh, IsTheSameOnAnyNumberOfThreads) {
    const TankScene scene = tank_with(
        {{Sphere{{0.15F, 0.09F, 0.12F}, 0.06F}}, cases::block({0, 0, 0}, {0.05F, 0.4F, 0.1F})});
    core::ThreadPool one(1), three(3);
    EXPECT_EQ(solid_mesh(scene, 2, one), solid_mesh(scene, 2, three));
}

}  // namespace
}  // namespace pastoso::tank
