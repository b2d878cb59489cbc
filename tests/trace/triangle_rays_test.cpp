#include "trace/triangle_rays.hpp"

#include "core/error.hpp"
#include "trace/numbers.hpp"
#include "trace/sampler.hpp"
#include "trace/scenes.hpp"

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <limits>
#include <sys/resource.h>
#include <thread>
#include <unistd.h>
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

/// Triangles that have nothing to do with each other, of sides up to 0.5.
liquid::TriangleMesh loose_triangles(std::uint32_t count) {
    liquid::TriangleMesh mesh;
    Sampler sampler(5, 0, 0);
    for (std::uint32_t t = 0; t < count; ++t) {
        const glm::vec3 place(sampler.next(), sampler.next(), sampler.next());
        for (int corner = 0; corner < 3; ++corner)
            mesh.positions_m.push_back(
                place + 0.5F * (glm::vec3(sampler.next(), sampler.next(), sampler.next()) - 0.5F));
        mesh.triangles.push_back({3 * t, 3 * t + 1, 3 * t + 2});
    }
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
    const glm::dvec3 o(ray.origin), d(ray.direction);
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

void expect_what_all_triangles_say(const liquid::TriangleMesh& mesh) {
    const TriangleRays triangles(mesh);
    int hits = 0;
    for (const MeshRay& ray : random_rays(1500)) {
        const MeshHit hit = triangles.closest(ray);
        // Rounding of single precision at grazing angles.
        EXPECT_NEAR(hit.distance, slow_distance(mesh, ray), 2e-5);
        EXPECT_EQ(triangles.anything_between(ray), hit.triangle != kNoTriangle);
        if (hit.triangle == kNoTriangle) continue;
        ++hits;
        const auto& [a, b, c] = mesh.triangles[hit.triangle];
        const glm::vec3 place = mesh.positions_m[a] * (1.0F - hit.second - hit.third) +
                                mesh.positions_m[b] * hit.second + mesh.positions_m[c] * hit.third;
        EXPECT_NEAR(glm::distance(place, ray.origin + ray.direction * hit.distance), 0.0F, 1e-5F);
    }
    EXPECT_GT(hits, 100);
    EXPECT_LT(hits, 1500);
}

TEST(TriangleRays, FindWhatATestOfAllTrianglesFinds) {
    expect_what_all_triangles_say(balls());
    expect_what_all_triangles_say(loose_triangles(60));
}

/// Through corners and edges of triangles, where two are equally near and rounding chooses.
std::vector<MeshRay> rays_at_edges(const liquid::TriangleMesh& mesh) {
    std::vector<MeshRay> rays;
    for (const MeshRay& ray : random_rays(500)) {
        const auto& triangle = mesh.triangles[rays.size() % mesh.triangles.size()];
        const glm::vec3 a = mesh.positions_m[triangle[0]], b = mesh.positions_m[triangle[1]];
        const glm::vec3 target = rays.size() % 2 == 0 ? a : 0.5F * (a + b);
        rays.push_back({ray.origin, glm::normalize(target - ray.origin), ray.nearest, 10.0F});
    }
    return rays;
}

void expect_the_same_bits(const TriangleRays& one, const TriangleRays& other, const MeshRay& ray) {
    const MeshHit a = one.closest(ray), b = other.closest(ray);
    EXPECT_EQ(a.triangle, b.triangle);
    EXPECT_EQ(a.distance, b.distance);
    EXPECT_EQ(a.second, b.second);
    EXPECT_EQ(a.third, b.third);
    EXPECT_EQ(one.anything_between(ray), other.anything_between(ray));
}

TEST(TriangleRays, EveryInstructionSetFindsTheSameBits) {
    for (const liquid::TriangleMesh& mesh : {balls(), loose_triangles(60)}) {
        std::vector<MeshRay> rays = random_rays(2000);
        for (const MeshRay& ray : rays_at_edges(mesh))
            rays.push_back(ray);
        const TriangleRays baseline(mesh, core::Isa::Baseline);
        for (const core::Isa isa : {core::Isa::Avx2, core::Isa::Avx512}) {
            if (isa > core::best_isa()) continue;
            SCOPED_TRACE(core::name_of(isa));
            const TriangleRays wide(mesh, isa);
            for (const MeshRay& ray : rays)
                expect_the_same_bits(baseline, wide, ray);
        }
    }
}

TEST(TriangleRays, TheSameMeshBuiltAgainFindsTheSameBits) {
    const TriangleRays one(balls()), again(balls());
    for (const MeshRay& ray : random_rays(2000))
        expect_the_same_bits(one, again, ray);
}

TEST(TriangleRays, NoneLeaksOutOfAClosedBallThroughItsEdges) {
    liquid::TriangleMesh mesh;
    tests::add_ball(mesh, {0.0F, 0.0F, 0.0F}, 1.0F, 6);
    const TriangleRays triangles(mesh);
    for (const auto& triangle : mesh.triangles) {
        const glm::vec3 a = mesh.positions_m[triangle[0]], b = mesh.positions_m[triangle[1]];
        for (const glm::vec3& target : {a, 0.5F * (a + b), glm::mix(a, b, 0.3F)})
            for (const glm::vec3& origin : {glm::vec3(0.0F), glm::vec3(0.1F, -0.2F, 0.3F)})
                EXPECT_TRUE(
                    triangles.anything_between({origin, glm::normalize(target - origin), 0.0F, 10.0F}));
    }
}

TEST(TriangleRays, AMeshWithoutTrianglesIsNeverMet) {
    const MeshRay ray{{0, 0, 0}, {0, 0, 1}, 0.0F, 10.0F};
    for (const TriangleRays& triangles : {TriangleRays(), TriangleRays(liquid::TriangleMesh())}) {
        EXPECT_TRUE(triangles.empty());
        EXPECT_EQ(triangles.closest(ray).triangle, kNoTriangle);
        EXPECT_EQ(triangles.closest(ray).distance, 10.0F);
        EXPECT_FALSE(triangles.anything_between(ray));
    }
}

TEST(TriangleRays, ManyTrianglesInOnePlaceAreFound) {
    liquid::TriangleMesh mesh;
    mesh.positions_m = {{0, 0, 1}, {1, 0, 1}, {0, 1, 1}};
    mesh.triangles.assign(1000, {0, 1, 2});
    const MeshRay ray{{0.2F, 0.2F, 0}, {0, 0, 1}, 0.0F, 10.0F};
    const MeshHit hit = TriangleRays(mesh).closest(ray);
    EXPECT_EQ(hit.distance, 1.0F);
    EXPECT_EQ(hit.triangle, 0U);
}

TEST(TriangleRays, TrianglesWithoutAreaAreNotMetAndKeepTheirNumber) {
    liquid::TriangleMesh mesh;
    mesh.positions_m = {{0, 0, 1}, {1, 0, 1}, {0, 1, 1}, {0.2F, 0.2F, 0.5F}};
    mesh.triangles = {{3, 3, 3}, {0, 0, 1}, {0, 1, 2}};
    const TriangleRays triangles(mesh);
    EXPECT_EQ(triangles.closest({{0.3F, 0.2F, 0}, {0, 0, 1}, 0.0F, 10.0F}).triangle, 2U);
    EXPECT_EQ(triangles.closest({{0.9F, 0.9F, 0}, {0, 0, 1}, 0.0F, 10.0F}).triangle, kNoTriangle);
}

std::ptrdiff_t threads_of_this_process() {
    return std::distance(std::filesystem::directory_iterator("/proc/self/task"), {});
}

/// Ends with the number of threads that building has left running.
[[noreturn]] void build_and_count_threads() {
    std::thread([] {}).join();  // a sanitizer starts one of its own with the first thread
    const std::ptrdiff_t before = threads_of_this_process();
    const auto build = [] { const TriangleRays triangles(loose_triangles(20000)); };
    build();
    std::thread(build).join();
    const TriangleRays one(loose_triangles(20000)), two(loose_triangles(20000), core::Isa::Baseline);
    std::_Exit(static_cast<int>(threads_of_this_process() - before));
}

TEST(TriangleRaysDeathTest, BuildingStartsNoThreads) {
    // In a process of its own: a thread that an earlier test has started would not be started again.
    GTEST_FLAG_SET(death_test_style, "threadsafe");
    EXPECT_EXIT(build_and_count_threads(), testing::ExitedWithCode(0), "");
}

TEST(TriangleRays, DenormalNumbersStayWhatTheyAre) {
    const TriangleRays triangles(loose_triangles(20000));
    for (const MeshRay& ray : random_rays(10))
        triangles.closest(ray);
    volatile float small = std::numeric_limits<float>::min();
    EXPECT_EQ(small * 0.5F * 2.0F, small);
    EXPECT_GT(small * 0.5F, 0.0F);
}

#if !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
/// Leaves the process as much memory more as the triangles' hierarchy does not find room in.
[[noreturn]] void build_in_little_memory() {
    liquid::TriangleMesh mesh = loose_triangles(400000);
    mesh.positions_m.reserve(mesh.positions_m.size() + 1);
    std::size_t pages = 0;
    std::ifstream("/proc/self/statm") >> pages;
    const rlimit limit{pages * static_cast<rlim_t>(::getpagesize()) + 8'000'000, RLIM_INFINITY};
    ::setrlimit(RLIMIT_AS, &limit);
    try {
        const TriangleRays triangles(std::move(mesh));
    } catch (const core::InputError& error) {
        std::fputs(error.what(), stderr);
        std::_Exit(7);
    }
    std::_Exit(0);
}

TEST(TriangleRaysDeathTest, TooLittleMemoryIsAnInputError) {
    EXPECT_EXIT(build_in_little_memory(), testing::ExitedWithCode(7),
                "not enough memory to trace a mesh of 400000 triangles");
}
#endif

}  // namespace
}  // namespace pastoso::trace
