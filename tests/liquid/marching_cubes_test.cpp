#include "liquid/surface/marching_cubes.hpp"

#include "core/random.hpp"
#include "liquid/fields.hpp"
#include "liquid/mesh_checks.hpp"
#include "liquid/surface/cube_table.hpp"

#include <cmath>
#include <limits>
#include <numbers>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

namespace pastoso::liquid {
namespace {

using test::examine;
using test::sampled;
using test::unit_lattice;

const glm::vec3 kMiddle(0.487F, 0.503F, 0.496F);
constexpr float kRadius = 0.37F;

SampledField ball(int n) {
    return sampled(unit_lattice(n),
                   [](const glm::vec3& point) { return kRadius - glm::length(point - kMiddle); });
}

/// Inside with the chance of `quarters` / 4, values of any size on either side of 0.
SampledField random_signs(int n, int quarters, std::uint32_t seed) {
    std::uint32_t index = 0;
    return sampled(unit_lattice(n), [&](const glm::vec3&) {
        const bool inside = 4.0F * core::uniform_noise(index, seed) < static_cast<float>(quarters);
        const float size = 0.01F + core::uniform_noise(index++, seed + 100);
        return inside ? size : -size;
    });
}

TEST(CubeTable, HasAllCasesWithFiveTrianglesAtMost) {
    int total = 0;
    for (int corners = 0; corners < 256; ++corners) {
        const CubeCase& cube = cube_table()[static_cast<std::size_t>(corners)];
        EXPECT_LE(cube.triangle_count, 5) << corners;
        total += cube.triangle_count;
        for (int c = 0; c < 3 * cube.triangle_count; ++c) {
            const auto [low, high] = cube_edge(cube.edges[c]);
            EXPECT_NE(corners >> low & 1, corners >> high & 1) << corners;
        }
        EXPECT_EQ(cube.triangle_count == 0, corners == 0 || corners == 255);
    }
    // Counted once, by a program of its own: the sum over all cases.
    EXPECT_EQ(total, 820);
}

TEST(CubeTable, ACornerAloneIsCutOffOutwards) {
    const CubeCase& cube = cube_table()[1];
    ASSERT_EQ(cube.triangle_count, 1);
    const auto middle = [](int edge) {
        const auto [low, high] = cube_edge(edge);
        const auto at = [](int c) { return glm::vec3(c & 1, c >> 1 & 1, c >> 2); };
        return 0.5F * (at(low) + at(high));
    };
    const glm::vec3 a = middle(cube.edges[0]), b = middle(cube.edges[1]), c = middle(cube.edges[2]);
    EXPECT_GT(glm::dot(glm::cross(b - a, c - a), glm::vec3(1.0F)), 0.0F);
}

TEST(MarchingCubes, AnySignsGiveAClosedManifold) {
    core::ThreadPool pool(1);
    for (const int quarters : {1, 2, 3}) {
        for (const std::uint32_t seed : {1U, 2U}) {
            const TriangleMesh mesh =
                marching_cubes(random_signs(24, quarters, seed).view(), 0.0F, pool);
            const test::MeshReport report = examine(mesh);
            EXPECT_GT(mesh.triangles.size(), 10'000U);
            EXPECT_EQ(report.bad_edges, 0U) << quarters << " seed " << seed;
            EXPECT_EQ(report.bad_vertices, 0U) << quarters << " seed " << seed;
            EXPECT_GT(volume_m3(mesh), 0.0);
        }
    }
}

TEST(MarchingCubes, EveryCaseAloneIsClosed) {
    core::ThreadPool pool(1);
    const Lattice lattice{2, 2, 2, 1.0F, {}};
    for (int corners = 1; corners < 256; ++corners) {
        const SampledField field = sampled(lattice, [&](const glm::vec3& point) {
            const int corner = static_cast<int>(point.x) + 2 * static_cast<int>(point.y) +
                               4 * static_cast<int>(point.z);
            return (corners >> corner & 1) != 0 ? 1.0F : -1.0F;
        });
        const TriangleMesh mesh = marching_cubes(field.view(), 0.0F, pool);
        const test::MeshReport report = examine(mesh);
        EXPECT_EQ(report.bad_edges + report.bad_vertices, 0U) << corners;
        EXPECT_GT(volume_m3(mesh), 0.0) << corners;
    }
}

TEST(MarchingCubes, AnOpenBorderLeavesTheSurfaceOpen) {
    core::ThreadPool pool(1);
    const Lattice lattice{5, 4, 3, 0.5F, {1.0F, 2.0F, 3.0F}};
    const SampledField field = sampled(lattice, [](const glm::vec3& point) { return 1.8F - point.x; });
    MarchingOptions options;
    options.border = MeshBorder::Open;
    const TriangleMesh sheet = marching_cubes(field.view(), 0.0F, pool, options);
    EXPECT_EQ(sheet.triangles.size(), 2U * 3U * 2U);
    for (std::size_t v = 0; v < sheet.positions_m.size(); ++v) {
        EXPECT_NEAR(sheet.positions_m[v].x, 1.8F, 1e-6F);
        EXPECT_NEAR(glm::length(sheet.normals[v] - glm::vec3(1, 0, 0)), 0.0F, 1e-6F);
    }
    // Closed, it is the box from x = 1 to 1.8, but for the thickness of the walls' offset, 1e-4
    // spacings.
    const double box = 0.8 * 1.5 * 1.0;
    EXPECT_NEAR(volume_m3(marching_cubes(field.view(), 0.0F, pool)), box, 1e-3 * box);
}

TEST(MarchingCubes, ABallsVolumeConvergesInTheSecondOrder) {
    core::ThreadPool pool(1);
    const double exact = 4.0 / 3.0 * std::numbers::pi * std::pow(static_cast<double>(kRadius), 3.0);
    double before = 0.0;
    for (const int n : {16, 32, 64}) {
        const TriangleMesh mesh = marching_cubes(ball(n).view(), 0.0F, pool);
        const test::MeshReport report = examine(mesh);
        EXPECT_EQ(report.euler, 2);
        EXPECT_EQ(report.bad_edges + report.bad_vertices, 0U);
        const double error = 1.0 - volume_m3(mesh) / exact;
        // Chords lie within the ball.
        EXPECT_GT(error, 0.0);
        // Second order would be 4; the errors are 1.7e-2, 4.2e-3 and 1.06e-3.
        if (before > 0.0) {
            EXPECT_NEAR(before / error, 4.0, 0.3) << n;
        }
        before = error;
    }
    EXPECT_LT(before, 2e-3);
}

TEST(MarchingCubes, NormalsAreThoseOfTheBall) {
    core::ThreadPool pool(1);
    const TriangleMesh mesh = marching_cubes(ball(32).view(), 0.0F, pool);
    ASSERT_EQ(mesh.normals.size(), mesh.positions_m.size());
    for (std::size_t v = 0; v < mesh.normals.size(); ++v) {
        EXPECT_NEAR(glm::length(mesh.normals[v]), 1.0F, 1e-6F);
        // Central differences miss h^2 f''' / 6: 0.1 degrees here.
        const glm::vec3 exact = glm::normalize(mesh.positions_m[v] - kMiddle);
        EXPECT_GT(glm::dot(mesh.normals[v], exact), std::cos(0.2F / 57.3F));
    }
}

TEST(MarchingCubes, ATorusHasOneHole) {
    core::ThreadPool pool(1);
    const SampledField field = sampled(unit_lattice(64), [](const glm::vec3& point) {
        const glm::vec3 from = point - kMiddle;
        const float ring = std::hypot(from.x, from.y) - 0.31F;
        return 0.11F - std::hypot(ring, from.z);
    });
    const TriangleMesh mesh = marching_cubes(field.view(), 0.0F, pool);
    EXPECT_EQ(examine(mesh).euler, 0);
    const double exact = 2.0 * std::numbers::pi * std::numbers::pi * 0.31 * 0.11 * 0.11;
    // Chords of the tube's 44 spacings around: 1 %.
    EXPECT_NEAR(volume_m3(mesh), exact, 0.012 * exact);
}

TEST(MarchingCubes, MirroredFieldsGiveMirroredVolumes) {
    core::ThreadPool pool(1);
    const SampledField field = random_signs(16, 2, 7);
    const double volume = volume_m3(marching_cubes(field.view(), 0.0F, pool));
    for (int axis = 0; axis < 3; ++axis) {
        SampledField mirrored(field.lattice());
        for (int k = 0; k < 16; ++k)
            for (int j = 0; j < 16; ++j)
                for (int i = 0; i < 16; ++i)
                    mirrored.at(i, j, k) =
                        field.at(axis == 0 ? 15 - i : i, axis == 1 ? 15 - j : j, axis == 2 ? 15 - k : k);
        const TriangleMesh mesh = marching_cubes(mirrored.view(), 0.0F, pool);
        EXPECT_EQ(examine(mesh).bad_edges, 0U);
        // Saddles are cut along other diagonals, each worth a small part of a cell: a random sum of 3000
        // cells.
        EXPECT_NEAR(volume_m3(mesh), volume, 0.02 * volume);
    }
}

TEST(MarchingCubes, WhatIsNoNumberLiesOutside) {
    core::ThreadPool pool(1);
    SampledField field = ball(16);
    field.at(8, 8, 8) = std::numeric_limits<float>::quiet_NaN();
    const TriangleMesh mesh = marching_cubes(field.view(), 0.0F, pool);
    EXPECT_EQ(examine(mesh).bad_edges, 0U);
    EXPECT_EQ(examine(mesh).euler, 4);  // the ball and a bubble
    for (const glm::vec3& position : mesh.positions_m)
        EXPECT_TRUE(std::isfinite(position.x + position.y + position.z));
}

TEST(MarchingCubes, NothingInsideIsAnEmptyMesh) {
    core::ThreadPool pool(1);
    const TriangleMesh mesh = marching_cubes(ball(16).view(), 1.0F, pool);
    EXPECT_TRUE(mesh.empty());
    EXPECT_TRUE(mesh.positions_m.empty());
    // A single sample within is a small octahedron.
    const SampledField one(Lattice{1, 1, 1, 1.0F, {}}, 1.0F);
    EXPECT_EQ(marching_cubes(one.view(), 0.0F, pool).triangles.size(), 8U);
}

TEST(MarchingCubes, CellsOfABoxAreSampledAtTheirMiddles) {
    core::ThreadPool pool(1);
    grid::BoxField field({6, 5, 4, 0.1F}, 9.0F);  // ghosts are not looked at
    for (int k = 0; k < 4; ++k)
        for (int j = 0; j < 5; ++j)
            for (int i = 0; i < 6; ++i)
                field.at(i, j, k) = 0.2F - 0.1F * (static_cast<float>(i) + 0.5F);
    MarchingOptions options;
    options.border = MeshBorder::Open;
    const SampleView samples{cell_centres(field.shape()), field.row(0, 0), field.shape().stride_y(),
                             field.shape().stride_z()};
    const TriangleMesh mesh = marching_cubes(samples, 0.0F, pool, options);
    ASSERT_FALSE(mesh.empty());
    for (const glm::vec3& position : mesh.positions_m) {
        EXPECT_NEAR(position.x, 0.2F, 1e-6F);
        EXPECT_GE(position.z, 0.05F - 1e-6F);
        EXPECT_LE(position.z, 0.35F + 1e-6F);
    }
}

TEST(MarchingCubesThreads, GiveTheSameBitsWithEveryInstructionSet) {
    const SampledField field = random_signs(37, 2, 3);  // rows of more than a word
    core::ThreadPool one(1), three(3);
    MarchingOptions options;
    options.isa = core::Isa::Baseline;
    const TriangleMesh expected = marching_cubes(field.view(), 0.1F, one, options);
    MarchingCubes cubes(three);
    TriangleMesh mesh;
    for (const core::Isa isa : {core::Isa::Baseline, core::Isa::Avx2, core::Isa::Avx512}) {
        if (isa > core::best_isa()) continue;
        options.isa = isa;
        for (int run = 0; run < 2; ++run) {
            cubes.run(field.view(), 0.1F, options, mesh);
            EXPECT_EQ(mesh.positions_m, expected.positions_m) << core::name_of(isa);
            EXPECT_EQ(mesh.normals, expected.normals) << core::name_of(isa);
            EXPECT_EQ(mesh.triangles, expected.triangles) << core::name_of(isa);
        }
    }
}

}  // namespace
}  // namespace pastoso::liquid
