#include "liquid/tea/milk_surface.hpp"

#include "core/random.hpp"
#include "liquid/mesh_checks.hpp"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

namespace pastoso::liquid {
namespace {

constexpr grid::BoxShape kBox{32, 32, 32, 0.1F / 32.0F};
constexpr float kVolume = 26e-6F / 12000.0F;

/// Milk that fills a ball as densely as it is itself: places of a lattice, shaken.
std::vector<Parcel> milk_ball(const glm::vec3& middle_m, float radius_m) {
    std::vector<Parcel> parcels;
    const float step_m = std::cbrt(kVolume);
    const int reach = static_cast<int>(radius_m / step_m) + 1;
    std::uint32_t index = 0;
    for (int k = -reach; k <= reach; ++k)
        for (int j = -reach; j <= reach; ++j)
            for (int i = -reach; i <= reach; ++i) {
                glm::vec3 offset(i, j, k);
                for (int axis = 0; axis < 3; ++axis)
                    offset[axis] += 0.6F * core::uniform_noise(index++, 1) - 0.3F;
                if (glm::length(offset) * step_m < radius_m)
                    parcels.push_back({middle_m + step_m * offset, kVolume, 1.0F, -1});
            }
    return parcels;
}

TEST(MilkSurface, HoldsTheParcelsVolumeInAClosedMesh) {
    core::ThreadPool pool(1);
    MilkSurfaces surfaces(pool);
    std::vector<Parcel> parcels = milk_ball({0.05F, 0.05F, 0.05F}, 0.012F);
    // Two frames in the same memory: the second one with crumbs besides.
    for (int frame = 0; frame < 2; ++frame) {
        for (int crumb = 0; crumb < 40 * frame; ++crumb) {
            const auto share = [&](std::uint32_t stream) {
                return core::uniform_noise(static_cast<std::uint32_t>(crumb), stream) - 0.5F;
            };
            parcels.push_back(
                {{0.05F + 0.05F * share(5), 0.05F + 0.05F * share(6), 0.03F}, kVolume * 0.2F, 1.0F, -1});
        }
        const MilkSurface milk = surfaces.make(parcels, {}, kBox, {});
        // The default tolerance.
        EXPECT_LT(std::abs(milk.volume_error()), 5e-3);
        EXPECT_NEAR(milk.mesh_m3, volume_m3(milk.mesh), 1e-15);
        EXPECT_LT(milk.tries, 10);
        EXPECT_EQ(milk.mesh.normals.size(), milk.mesh.positions_m.size());
        const test::MeshReport report = test::examine(milk.mesh);
        EXPECT_EQ(report.bad_edges + report.bad_vertices, 0U);
    }
}

TEST(MilkSurface, TheBallIsAsLargeAsItsVolumeSays) {
    core::ThreadPool pool(1);
    const glm::vec3 middle(0.05F, 0.05F, 0.05F);
    const MilkSurface milk = MilkSurfaces(pool).make(milk_ball(middle, 0.012F), {}, kBox, {});
    double sum_m = 0.0;
    for (const glm::vec3& position : milk.mesh.positions_m)
        sum_m += static_cast<double>(glm::length(position - middle));
    const double radius_m = std::cbrt(milk.parcels_m3 * 3.0 / (4.0 * 3.14159265));
    // The ball is bumpy by a fraction of the parcels' distance of 1.3 mm.
    EXPECT_NEAR(sum_m / static_cast<double>(milk.mesh.positions_m.size()), radius_m, 0.0003);
}

TEST(MilkSurface, StaysWithinTheGlassAndBelowTheLevel) {
    core::ThreadPool pool(1);
    const Cup cup;
    MilkSurfaces surfaces(pool);
    const glm::vec3 places[] = {{0.05F, 0.05F, cup.floor_m},
                                {0.05F, 0.05F, cup.level_m},
                                {0.05F + cup.inner_radius_m(0.05F), 0.05F, 0.05F},
                                {0.05F, 0.05F - cup.inner_radius_m(0.03F), 0.03F}};
    for (const glm::vec3& place : places) {
        // Half of the parcels lie beyond: the others take their volume on.
        const MilkSurface milk = surfaces.make(milk_ball(place, 0.012F), cup, kBox, {});
        ASSERT_FALSE(milk.mesh.empty());
        EXPECT_EQ(test::examine(milk.mesh).bad_edges, 0U);
        for (const glm::vec3& position : milk.mesh.positions_m)
            // Vertices keep 1e-4 of a spacing away from samples: 2e-7 m.
            EXPECT_LE(tea_distance_m(cup, position), -0.00015F + 3e-7F);
    }
}

TEST(MilkSurface, SaysByHowMuchTheVolumeIsMissed) {
    core::ThreadPool pool(1);
    std::vector<Parcel> parcels(3000, Parcel{{0.05F, 0.05F, 0.05F}, kVolume, 1.0F, -1});
    const MilkSurface milk = MilkSurfaces(pool).make(parcels, {}, kBox, {});
    // All at one place: no more than a ball of the kernel's radius, 2.4 mm, 58e-9 of 6.5e-6 m3.
    EXPECT_LT(milk.volume_error(), -0.98);
    EXPECT_GT(milk.mesh_m3, 3e-8);
    EXPECT_FALSE(milk.mesh.empty());
}

TEST(MilkSurface, WithoutMilkThereIsNone) {
    core::ThreadPool pool(1);
    const MilkSurface milk = MilkSurfaces(pool).make({}, {}, kBox, {});
    EXPECT_TRUE(milk.mesh.empty());
    EXPECT_EQ(milk.volume_error(), 0.0);
}

TEST(MilkSurfaceThreads, GiveTheSameBitsWithEveryInstructionSet) {
    const std::vector<Parcel> parcels = milk_ball({0.04F, 0.06F, 0.02F}, 0.011F);
    core::ThreadPool one(1), three(3);
    MilkSurfaceSettings settings;
    settings.isa = core::Isa::Baseline;
    const MilkSurface expected = MilkSurfaces(one).make(parcels, {}, kBox, settings);
    for (const core::Isa isa : {core::Isa::Baseline, core::Isa::Avx2, core::Isa::Avx512}) {
        if (isa > core::best_isa()) continue;
        settings.isa = isa;
        const MilkSurface milk = MilkSurfaces(three).make(parcels, {}, kBox, settings);
        EXPECT_EQ(milk.threshold, expected.threshold);
        EXPECT_EQ(milk.mesh.positions_m, expected.mesh.positions_m) << core::name_of(isa);
        EXPECT_EQ(milk.mesh.normals, expected.mesh.normals) << core::name_of(isa);
        EXPECT_EQ(milk.mesh.triangles, expected.mesh.triangles) << core::name_of(isa);
    }
}

}  // namespace
}  // namespace pastoso::liquid
