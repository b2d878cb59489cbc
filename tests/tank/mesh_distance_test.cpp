#include "tank/mesh_distance.hpp"

#include "core/random.hpp"
#include "core/thread_pool.hpp"
#include "tank/closed_mesh.hpp"
#include "tank/meshes.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include <gtest/gtest.h>

namespace pastoso::tank {
namespace {

using test::block_mesh;
using test::inside_out;
using test::joined;
using test::sphere_mesh;
using test::torus_mesh;
using test::TriangleMesh;

/// The point of a triangle nearest to another, region by region (C. Ericson, "Real-Time Collision
/// Detection", 2005, 5.1.5).
glm::dvec3 nearest_point(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c,
                         const glm::dvec3& p) {
    const glm::dvec3 ab = b - a, ac = c - a;
    const double d1 = glm::dot(ab, p - a), d2 = glm::dot(ac, p - a);
    if (d1 <= 0.0 && d2 <= 0.0) return a;
    const double d3 = glm::dot(ab, p - b), d4 = glm::dot(ac, p - b);
    if (d3 >= 0.0 && d4 <= d3) return b;
    const double vc = d1 * d4 - d3 * d2;
    if (vc <= 0.0 && d1 >= 0.0 && d3 <= 0.0) return a + d1 / (d1 - d3) * ab;
    const double d5 = glm::dot(ab, p - c), d6 = glm::dot(ac, p - c);
    if (d6 >= 0.0 && d5 <= d6) return c;
    const double vb = d5 * d2 - d1 * d6;
    if (vb <= 0.0 && d2 >= 0.0 && d6 <= 0.0) return a + d2 / (d2 - d6) * ac;
    const double va = d3 * d6 - d5 * d4;
    if (va <= 0.0 && d4 >= d3 && d5 >= d6) return b + (d4 - d3) / ((d4 - d3) + (d5 - d6)) * (c - b);
    return a + vb / (va + vb + vc) * ab + vc / (va + vb + vc) * ac;
}

/// The solid angle of a triangle (A. van Oosterom and J. Strackee, IEEE Trans. Biomed. Eng. 30, 1983).
double solid_angle(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c) {
    const double la = glm::length(a), lb = glm::length(b), lc = glm::length(c);
    return 2.0 *
           std::atan2(glm::dot(a, glm::cross(b, c)),
                      la * lb * lc + glm::dot(a, b) * lc + glm::dot(b, c) * la + glm::dot(c, a) * lb);
}

/// The same over all triangles, with solid angles for the side.
double reference(const TriangleMesh& mesh, const glm::vec3& point) {
    const glm::dvec3 p(point);
    double nearest = std::numeric_limits<double>::infinity(), angle = 0.0;
    for (const auto& [first, second, third] : mesh.triangles) {
        const glm::dvec3 a(mesh.positions_m[first]), b(mesh.positions_m[second]),
            c(mesh.positions_m[third]);
        nearest = std::min(nearest, glm::distance(p, nearest_point(a, b, c, p)));
        angle += solid_angle(a - p, b - p, c - p);
    }
    const bool is_within = std::abs(angle) > 2.0 * 3.14159265358979;
    return is_within ? -nearest : nearest;
}

glm::vec3 random_point(std::uint32_t index, std::uint32_t seed, const glm::vec3& low,
                       const glm::vec3& high) {
    const glm::vec3 share(core::uniform_noise(index, 3 * seed), core::uniform_noise(index, 3 * seed + 1),
                          core::uniform_noise(index, 3 * seed + 2));
    return low + share * (high - low);
}

/// In a box somewhat larger than the mesh, and on a lattice whose planes go through many vertices.
void expect_reference(const TriangleMesh& mesh, std::uint32_t seed) {
    check_closed(mesh);
    const MeshDistance distance(mesh);
    glm::vec3 low(1e9F), high(-1e9F);
    for (const glm::vec3& position : mesh.positions_m) {
        low = glm::min(low, position);
        high = glm::max(high, position);
    }
    const glm::vec3 size = high - low;
    const auto largest = static_cast<double>(std::max({size.x, size.y, size.z}));
    for (std::uint32_t n = 0; n < 1000; ++n) {
        glm::vec3 point = random_point(n, seed, low - 0.3F * size, high + 0.3F * size);
        if (n % 2 == 1) point = glm::round(8.0F * point) / 8.0F;
        const double expected = reference(mesh, point), found = static_cast<double>(distance(point));
        // Differences of floats of the mesh' size are squared and summed.
        EXPECT_NEAR(std::abs(found), std::abs(expected), 1e-6 * largest) << "point " << n;
        if (std::abs(expected) > 1e-6 * largest) {
            EXPECT_EQ(found < 0.0, expected < 0.0)
                << "seed " << seed << ", point " << n << " at " << point.x << ", " << point.y << ", "
                << point.z << ", " << expected << " away";
        }
    }
}

/// Every second vertex drawn out: the nearest points are mostly sharp corners and edges.
TriangleMesh star() {
    TriangleMesh mesh = sphere_mesh({}, 1.0F, 2);
    for (std::size_t i = 0; i < mesh.positions_m.size(); i += 2)
        mesh.positions_m[i] *= 2.0F;
    return mesh;
}

/// Four corners of a wedge that is a thousandth as thick as long.
TriangleMesh wedge() {
    return {{{0, 0, 0}, {1, 0.1F, 0}, {0, 1, 0.3F}, {0.4F, 0.4F, 0.101F}},
            {},
            {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}}};
}

TEST(MeshDistance, IsThatOfAllTrianglesOnTheSideOfTheirSolidAngles) {
    expect_reference(block_mesh({-1, -0.5F, -1}, {1, 0.5F, 0.25F}), 1);
    expect_reference(torus_mesh(1.0F, 0.3F, 24), 2);
    expect_reference(star(), 3);
    expect_reference(wedge(), 4);
}

TEST(MeshDistance, BodiesWithinEachOtherAndOverlappingOnesAreToldApart) {
    const TriangleMesh hollow =
        joined(sphere_mesh({}, 1.0F, 3), inside_out(sphere_mesh({0.125F, 0, 0}, 0.5F, 3)));
    expect_reference(hollow, 5);
    EXPECT_GT(MeshDistance(hollow)({0.125F, 0.0F, 0.0F}), 0.45F);
    const TriangleMesh overlapping =
        joined(sphere_mesh({}, 1.0F, 3), sphere_mesh({0.7F, 0.1F, 0.2F}, 0.8F, 3));
    expect_reference(overlapping, 6);
}

TEST(MeshDistance, InsideOutTheDistanceIsTheSame) {
    const TriangleMesh mesh = torus_mesh(1.0F, 0.3F, 24);
    const MeshDistance distance(mesh), turned(inside_out(mesh));
    for (std::uint32_t n = 0; n < 500; ++n) {
        const glm::vec3 point = random_point(n, 7, glm::vec3(-1.5F), glm::vec3(1.5F));
        EXPECT_NEAR(distance(point), turned(point), 1e-6F);
    }
}

/// A block whose edge at the top is cut in two for one side alone; a triangle without area closes the
/// gap.
TEST(MeshDistance, TrianglesWithoutAreaDoNoHarm) {
    TriangleMesh mesh = block_mesh({0, 0, 0}, {1, 1, 1});
    mesh.positions_m.emplace_back(0.5F, 0.0F, 1.0F);
    // {4, 5, 7} belongs to the top; its edge from 4 to 5 goes by way of 8.
    mesh.triangles.erase(mesh.triangles.begin() + 2);
    mesh.triangles.insert(mesh.triangles.end(), {{4, 8, 7}, {8, 5, 7}, {4, 5, 8}});
    expect_reference(mesh, 8);
    const MeshDistance distance(mesh);
    EXPECT_NEAR(distance({0.5F, -0.3F, 1.4F}), 0.5F, 1e-6F);
    EXPECT_NEAR(distance({0.25F, -0.3F, 1.4F}), 0.5F, 1e-6F);
    EXPECT_NEAR(distance({0.25F, 0.125F, 0.875F}), -0.125F, 1e-6F);
}

TEST(MeshDistance, ASphereOfTrianglesIsASphere) {
    constexpr int kLevels = 5;
    const MeshDistance distance(sphere_mesh({0.1F, 0.2F, 0.3F}, 0.5F, kLevels));
    // An edge of the octahedron, of a quarter turn, is cut into 2^levels; a triangle's middle lies at
    // most 2/3 of its height from its corners, and 1 - cos of that angle below the sphere.
    const float angle = 1.5707963F / 32.0F;
    const float below = 0.5F * (1.0F - std::cos(angle));
    for (std::uint32_t n = 0; n < 2000; ++n) {
        const glm::vec3 point = random_point(n, 9, glm::vec3(-0.5F), glm::vec3(1.0F));
        const float exact = glm::distance(point, {0.1F, 0.2F, 0.3F}) - 0.5F;
        EXPECT_GE(distance(point), exact - 1e-6F);
        EXPECT_LE(distance(point), exact + below);
    }
}

TEST(MeshDistance, WithinTheReachItIsTheSameAndBeyondItTheSideIs) {
    const MeshDistance distance(star());
    for (std::uint32_t n = 0; n < 2000; ++n) {
        const glm::vec3 point = random_point(n, 10, glm::vec3(-3.0F), glm::vec3(3.0F));
        const float reach = 0.01F + core::uniform_noise(n, 31);
        const float whole = distance(point), near = distance(point, reach);
        EXPECT_EQ(near, std::abs(whole) < reach ? whole : std::copysign(reach, whole));
    }
}

TEST(MeshDistance, MirroredMeshesHaveMirroredDistances) {
    const TriangleMesh mesh = star();
    const MeshDistance distance(mesh);
    for (const int axis : {0, 1, 2}) {
        const MeshDistance other(test::mirrored(mesh, axis));
        for (std::uint32_t n = 0; n < 500; ++n) {
            glm::vec3 point = random_point(n, 11, glm::vec3(-2.0F), glm::vec3(2.0F));
            const float expected = distance(point);
            point[axis] = -point[axis];
            // A triangle's corners come in another order.
            EXPECT_NEAR(other(point), expected, 1e-6F) << axis << ", point " << n;
        }
    }
}

TEST(MeshDistance, ThreadsAskAtTheSameTime) {
    const MeshDistance distance(star());
    const auto ask = [&](int threads) {
        std::vector<float> distances(20'000);
        core::ThreadPool pool(threads);
        pool.run(distances.size(), [&](std::size_t n, int) {
            distances[n] = distance(
                random_point(static_cast<std::uint32_t>(n), 12, glm::vec3(-2.0F), glm::vec3(2.0F)));
        });
        return distances;
    };
    EXPECT_EQ(ask(1), ask(3));
}

}  // namespace
}  // namespace pastoso::tank
