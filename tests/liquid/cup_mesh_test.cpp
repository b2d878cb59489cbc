#include "liquid/vessel/cup_mesh.hpp"

#include <cmath>
#include <numbers>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

namespace pastoso::liquid {
namespace {

double volume_of(const TriangleMesh& a, const TriangleMesh& b, double sign_of_b) {
    return volume_m3(a) + sign_of_b * volume_m3(b);
}

TEST(CupMesh, TeaAndGlassAreEnclosed) {
    const Cup cup;
    const CupMeshes meshes = cup_meshes(cup, 256);
    // Sides of a polygon of 256 corners lie within the circle: 1e-4 of the volume.
    const double tea = tea_volume_m3(cup);
    EXPECT_NEAR(volume_of(meshes.tea_glass, meshes.tea_air, 1.0), tea, 2e-4 * tea);
    // The glass: a frustum less that of the room within, which is open above the level.
    const auto frustum = [&](double low_z, double high_z, double wall) {
        const double a = static_cast<double>(cup.inner_radius_m(static_cast<float>(low_z))) + wall;
        const double b = static_cast<double>(cup.inner_radius_m(static_cast<float>(high_z))) + wall;
        return std::numbers::pi / 3.0 * (high_z - low_z) * (a * a + a * b + b * b);
    };
    const double rim = static_cast<double>(cup.rim_m), foot = static_cast<double>(cup.foot_m);
    const double glass = frustum(foot, rim, static_cast<double>(cup.wall_m)) -
                         frustum(static_cast<double>(cup.floor_m), rim, 0.0);
    EXPECT_NEAR(volume_of(meshes.glass_air, meshes.tea_glass, -1.0), glass, 1e-3 * glass);
}

TEST(CupMesh, NormalsPointAsTheTrianglesDo) {
    const CupMeshes meshes = cup_meshes(Cup{}, 64);
    for (const TriangleMesh* mesh : {&meshes.glass_air, &meshes.tea_glass, &meshes.tea_air}) {
        ASSERT_EQ(mesh->normals.size(), mesh->positions_m.size());
        for (const auto& [a, b, c] : mesh->triangles) {
            const glm::vec3 flat =
                glm::normalize(glm::cross(mesh->positions_m[b] - mesh->positions_m[a],
                                          mesh->positions_m[c] - mesh->positions_m[a]));
            // Half a segment of 5.6 degrees away.
            EXPECT_GT(glm::dot(flat, mesh->normals[a]), 0.995F);
            EXPECT_NEAR(glm::length(mesh->normals[a]), 1.0F, 1e-6F);
        }
    }
    for (const glm::vec3& normal : meshes.tea_air.normals)
        EXPECT_EQ(normal, glm::vec3(0, 0, 1));
}

TEST(CupMesh, TheTeasSurfaceIsThatOfTheDistance) {
    const Cup cup;
    for (const glm::vec3& position : cup_meshes(cup).tea_glass.positions_m)
        EXPECT_NEAR(tea_distance_m(cup, position), 0.0F, 1e-8F);
}

}  // namespace
}  // namespace pastoso::liquid
