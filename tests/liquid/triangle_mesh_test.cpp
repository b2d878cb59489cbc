#include "liquid/surface/triangle_mesh.hpp"

#include <gtest/gtest.h>

namespace pastoso::liquid {
namespace {

TriangleMesh tetrahedron() {
    return {
        {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, {}, {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}}};
}

TEST(TriangleMesh, ATetrahedronEnclosesASixthOfItsBox) {
    EXPECT_DOUBLE_EQ(volume_m3(tetrahedron()), 1.0 / 6.0);
}

TEST(TriangleMesh, TheVolumeDoesNotDependOnThePlace) {
    TriangleMesh mesh = tetrahedron();
    for (glm::vec3& position : mesh.positions_m)
        position += glm::vec3(3.0F, -5.0F, 7.0F);
    EXPECT_NEAR(volume_m3(mesh), 1.0 / 6.0, 1e-12);
}

TEST(TriangleMesh, InsideOutItIsNegative) {
    TriangleMesh mesh = tetrahedron();
    for (auto& triangle : mesh.triangles)
        std::swap(triangle[1], triangle[2]);
    EXPECT_DOUBLE_EQ(volume_m3(mesh), -1.0 / 6.0);
}

}  // namespace
}  // namespace pastoso::liquid
