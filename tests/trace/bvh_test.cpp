#include "trace/bvh.hpp"

#include "trace/numbers.hpp"
#include "trace/sampler.hpp"
#include "trace/scenes.hpp"

#include <vector>

#include <gtest/gtest.h>

namespace pastoso::trace {
namespace {

liquid::TriangleMesh balls() {
    liquid::TriangleMesh mesh;
    Sampler sampler(3, 0, 0);
    for (int i = 0; i < 12; ++i)
        tests::add_ball(mesh, {sampler.next(), sampler.next(), sampler.next()},
                        0.05F + 0.1F * sampler.next(), 8);
    return mesh;
}

std::vector<MeshRay> random_rays(int count) {
    std::vector<MeshRay> rays;
    Sampler sampler(4, 0, 0);
    for (int i = 0; i < count; ++i) {
        const float z = 1.0F - 2.0F * sampler.next();
        const glm::vec2 turn = cos_sin_of_turns(sampler.next()) * std::sqrt(1.0F - z * z);
        rays.push_back({{sampler.next(), sampler.next(), sampler.next()},
                        {turn.x, turn.y, z},
                        1e-6F,
                        2.0F * sampler.next()});
    }
    return rays;
}

/// The nearest distance by the formula of Moeller and Trumbore in double precision, over all triangles.
double slow_distance(const liquid::TriangleMesh& mesh, const MeshRay& ray) {
    const glm::dvec3 o(ray.origin[0], ray.origin[1], ray.origin[2]);
    const glm::dvec3 d(ray.direction[0], ray.direction[1], ray.direction[2]);
    double nearest = ray.farthest;
    for (const auto& [ia, ib, ic] : mesh.triangles) {
        const glm::dvec3 a(mesh.positions_m[ia]), e1 = glm::dvec3(mesh.positions_m[ib]) - a,
                                                  e2 = glm::dvec3(mesh.positions_m[ic]) - a;
        const glm::dvec3 p = glm::cross(d, e2), t = o - a, q = glm::cross(t, e1);
        const double det = glm::dot(e1, p), u = glm::dot(t, p) / det, v = glm::dot(d, q) / det;
        const double distance = glm::dot(e2, q) / det;
        if (u >= 0.0 && v >= 0.0 && u + v <= 1.0 && distance > ray.nearest && distance < nearest)
            nearest = distance;
    }
    return nearest;
}

TEST(Bvh, FindsWhatATestOfAllTrianglesFinds) {
    const liquid::TriangleMesh mesh = balls();
    const Bvh bvh(mesh);
    const BvhKernels& kernels = bvh_kernels(core::best_isa());
    int hits = 0;
    for (const MeshRay& ray : random_rays(1500)) {
        const MeshHit hit = bvh.closest(ray, kernels);
        // Rounding of single precision at grazing angles.
        EXPECT_NEAR(hit.distance, slow_distance(mesh, ray), 2e-5);
        EXPECT_EQ(bvh.occluded(ray, kernels), hit.triangle != kNoTriangle);
        if (hit.triangle == kNoTriangle) continue;
        ++hits;
        const auto& [a, b, c] = mesh.triangles[hit.triangle];
        const glm::vec3 place = mesh.positions_m[a] * (1.0F - hit.second - hit.third) +
                                mesh.positions_m[b] * hit.second + mesh.positions_m[c] * hit.third;
        const glm::vec3 along =
            glm::vec3(ray.origin[0], ray.origin[1], ray.origin[2]) +
            glm::vec3(ray.direction[0], ray.direction[1], ray.direction[2]) * hit.distance;
        EXPECT_NEAR(glm::distance(place, along), 0.0F, 1e-5F);
    }
    EXPECT_GT(hits, 100);
}

TEST(Bvh, EveryInstructionSetFindsTheSameBits) {
    const Bvh bvh(balls());
    const core::Isa best = core::best_isa();
    for (const core::Isa isa : {core::Isa::Baseline, core::Isa::Avx2, core::Isa::Avx512}) {
        if (isa > best) continue;
        for (const MeshRay& ray : random_rays(2000)) {
            const MeshHit one = bvh.closest(ray, bvh_kernels(core::Isa::Baseline));
            const MeshHit other = bvh.closest(ray, bvh_kernels(isa));
            ASSERT_EQ(one.distance, other.distance);
            ASSERT_EQ(one.second, other.second);
            ASSERT_EQ(one.triangle, other.triangle);
        }
    }
}

TEST(Bvh, NoRayLeaksOutOfAClosedBallThroughItsEdges) {
    liquid::TriangleMesh mesh;
    tests::add_ball(mesh, {0.0F, 0.0F, 0.0F}, 1.0F, 6);
    const Bvh bvh(mesh);
    for (const auto& triangle : mesh.triangles) {
        const glm::vec3 a = mesh.positions_m[triangle[0]], b = mesh.positions_m[triangle[1]];
        for (const glm::vec3& target : {a, 0.5F * (a + b), glm::mix(a, b, 0.3F)})
            for (const glm::vec3& origin : {glm::vec3(0.0F), glm::vec3(0.1F, -0.2F, 0.3F)}) {
                const glm::vec3 d = glm::normalize(target - origin);
                const MeshRay ray{{origin.x, origin.y, origin.z}, {d.x, d.y, d.z}, 0.0F, 10.0F};
                EXPECT_TRUE(bvh.occluded(ray, bvh_kernels(core::best_isa())));
            }
    }
}

TEST(Bvh, AMeshWithoutTrianglesIsNeverMet) {
    const Bvh bvh((liquid::TriangleMesh()));
    const MeshRay ray{{0, 0, 0}, {0, 0, 1}, 0.0F, 10.0F};
    EXPECT_EQ(bvh.closest(ray, bvh_kernels(core::best_isa())).triangle, kNoTriangle);
    EXPECT_FALSE(bvh.occluded(ray, bvh_kernels(core::best_isa())));
}

TEST(Bvh, ManyTrianglesInOnePlaceStillPartIntoLeaves) {
    liquid::TriangleMesh mesh;
    mesh.positions_m = {{0, 0, 1}, {1, 0, 1}, {0, 1, 1}};
    mesh.triangles.assign(1000, {0, 1, 2});
    const Bvh bvh(mesh);
    const MeshRay ray{{0.2F, 0.2F, 0}, {0, 0, 1}, 0.0F, 10.0F};
    EXPECT_EQ(bvh.closest(ray, bvh_kernels(core::best_isa())).distance, 1.0F);
}

}  // namespace
}  // namespace pastoso::trace
