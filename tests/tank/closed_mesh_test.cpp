#include "tank/closed_mesh.hpp"

#include "core/error.hpp"
#include "tank/meshes.hpp"

#include <limits>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace pastoso::tank {
namespace {

using test::block_mesh;
using test::inside_out;
using test::TriangleMesh;
using ::testing::AllOf;
using ::testing::HasSubstr;

std::string fault(const TriangleMesh& mesh) {
    try {
        check_closed(mesh);
    } catch (const core::InputError& error) {
        return error.what();
    }
    return "";
}

const TriangleMesh kBlock = block_mesh({0, 0, 0}, {1, 1, 1});

TEST(ClosedMesh, ClosedMeshesPass) {
    EXPECT_EQ(fault(kBlock), "");
    EXPECT_EQ(fault(inside_out(kBlock)), "");
    EXPECT_EQ(fault(test::torus_mesh(2, 1, 16)), "");
    EXPECT_EQ(fault(test::joined(test::sphere_mesh({}, 2, 3), inside_out(kBlock))), "");
}

TEST(ClosedMesh, AMissingTriangleIsNoticed) {
    TriangleMesh mesh = kBlock;
    mesh.triangles.erase(mesh.triangles.begin() + 2);
    EXPECT_THAT(fault(mesh), AllOf(HasSubstr("it is not closed: the edge from (0, 0, 1) to (1, 0, 1)"),
                                   HasSubstr("exactly two triangles")));
}

TEST(ClosedMesh, ATurnedTriangleIsNoticed) {
    TriangleMesh mesh = kBlock;
    std::swap(mesh.triangles[5][0], mesh.triangles[5][1]);
    EXPECT_THAT(fault(mesh), HasSubstr("it is not closed"));
}

TEST(ClosedMesh, ATriangleThatStandsTwiceIsNoticed) {
    TriangleMesh mesh = kBlock;
    mesh.triangles.push_back(mesh.triangles[7]);
    EXPECT_THAT(fault(mesh), HasSubstr("it is not closed"));
    // Together with one that is turned round every edge has as many of either direction.
    mesh.triangles.push_back({mesh.triangles[7][0], mesh.triangles[7][2], mesh.triangles[7][1]});
    EXPECT_THAT(fault(mesh), HasSubstr("it is not closed"));
}

TEST(ClosedMesh, WhatIsNoMeshIsNoticed) {
    EXPECT_EQ(fault({}), "mesh: there are no triangles.");
    TriangleMesh mesh = kBlock;
    mesh.triangles[3][1] = 8;
    EXPECT_EQ(fault(mesh), "mesh: triangle 3 names vertex 8 of 8.");
    mesh = kBlock;
    mesh.triangles[3] = {4, 4, 6};
    EXPECT_THAT(fault(mesh), HasSubstr("the edge from (0, 0, 1) to (0, 0, 1)"));
    mesh = kBlock;
    mesh.positions_m[5].y = std::numeric_limits<float>::quiet_NaN();
    EXPECT_EQ(fault(mesh), "mesh: vertex 5 lies at (1, nan, 1), which is no place.");
    mesh.positions_m[5].y = -1e30F;
    EXPECT_THAT(fault(mesh), HasSubstr("(1, -1e+30, 1)"));
}

}  // namespace
}  // namespace pastoso::tank
