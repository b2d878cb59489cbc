#include "trace/tank_scene.hpp"

#include "liquid/surface/marching_cubes.hpp"
#include "trace/camera_rays.hpp"
#include "trace/scenes.hpp"
#include "trace/world.hpp"

#include <algorithm>

#include <glm/common.hpp>
#include <gtest/gtest.h>

namespace pastoso::trace {
namespace {

const grid::BoxShape kRoom = {12, 8, 10, 0.05F};

/// Liquid up to a height, a little into the glass.
liquid::TriangleMesh liquid_to(float height_m) {
    core::ThreadPool pool(2);
    const liquid::Lattice lattice = {28, 20, 24, 0.025F, glm::vec3(0.0125F - 0.05F)};
    const float overlap_m = kTankOverlap_cells * kRoom.cell_m;
    const glm::vec3 low_m(-overlap_m), high_m(0.6F + overlap_m, 0.4F + overlap_m, height_m);
    liquid::SampledField depth_m(lattice);
    for (int k = 0; k < lattice.nz; ++k)
        for (int j = 0; j < lattice.ny; ++j)
            for (int i = 0; i < lattice.nx; ++i) {
                const glm::vec3 at_m = lattice.point_m(i, j, k);
                const glm::vec3 within_m = glm::min(at_m - low_m, high_m - at_m);
                depth_m.at(i, j, k) = std::min({within_m.x, within_m.y, within_m.z});
            }
    return liquid::marching_cubes(depth_m.view(), 0.0F, pool);
}

Scene scene_at(float height_m, float aspect = 1.0F) {
    return tank_scene(grid::BoxField(kRoom, 0.5F), liquid_to(height_m), {}, aspect);
}

TEST(TankScene, IsAModelWithGlassBetweenLiquidAndAir) {
    const Scene scene = scene_at(0.2F);
    check_scene(scene);
    EXPECT_NEAR(scene.tank->inner_high_m.x, kTankModel_m, 1e-6F);
    EXPECT_NEAR(scene.tank->inner_high_m.z, kTankModel_m * 10.0F / 12.0F, 1e-6F);
    EXPECT_NEAR(scene.milk_share.shape().cell_m * 12.0F, kTankModel_m, 1e-6F);
    Sampler sampler(1, 1, 1);
    Ray ray{{-0.1F, 0.1F, 0.05F}, {1, 0, 0}};
    unsigned here = kAir;
    std::vector<float> indices;
    // The milk's scattering left out, only surfaces count.
    Scene clear = scene;
    clear.milk_share = {};
    const World surfaces(clear);
    for (;;) {
        const World::Event event = surfaces.next_event(ray, here, sampler);
        if (event.hit.kind != SurfaceKind::Clear) break;
        here = event.hit.beyond(here, ray.direction);
        ray.origin += ray.direction * event.distance;
        const float index = surfaces.refractive_index(here);
        if (indices.empty() || indices.back() != index) indices.push_back(index);
    }
    EXPECT_EQ(indices, (std::vector<float>{1.5F, 1.335F, 1.5F, 1.0F}));
}

TEST(TankScene, TheWholeTankIsInThePictureAndFillsIt) {
    for (const float aspect : {0.5F, 1.0F, 1.5F, 2.5F}) {
        const Scene scene = scene_at(0.2F, aspect);
        const glm::vec3 forward = glm::normalize(scene.camera.target_m - scene.camera.eye_m);
        const glm::vec3 right = glm::normalize(glm::cross(forward, glm::vec3(0, 0, 1)));
        const glm::vec3 up = glm::cross(right, forward);
        const glm::vec2 half = cos_sin_of_turns(scene.camera.field_of_view_deg / 720.0F);
        float most = 0.0F;
        for (int corner = 0; corner < 8; ++corner) {
            glm::vec3 at = scene.tank->inner_high_m + scene.tank->wall_m;
            for (int axis = 0; axis < 3; ++axis)
                if ((corner >> axis & 1) == 0)
                    at[axis] = scene.tank->inner_low_m[axis] - scene.tank->wall_m;
            const glm::vec3 way = at - scene.camera.eye_m;
            const float scale = half.x / (half.y * glm::dot(way, forward));
            most = std::max({most, std::abs(glm::dot(way, up)) * scale,
                             std::abs(glm::dot(way, right)) * scale / aspect});
        }
        EXPECT_LT(most, 1.0F) << aspect;
        EXPECT_GT(most, 0.9F) << aspect;
    }
}

TEST(TankScene, MoreMilkMakesTheLiquidLighter) {
    core::ThreadPool pool(2);
    const liquid::TriangleMesh liquid = liquid_to(0.4F);
    double seen[2];
    for (const int milky : {0, 1}) {
        const grid::BoxField milk(kRoom, 0.3F * static_cast<float>(milky));
        Scene scene = tank_scene(milk, liquid, {}, 1.0F);
        scene.camera.field_of_view_deg = 5.0F;  // liquid alone
        PathTracer tracer(scene, tests::small_picture(8), pool);
        tracer.add_samples(16);
        seen[milky] = tests::mean_of(tracer.radiance());
    }
    EXPECT_GT(seen[1], 1.1 * seen[0]);
}

}  // namespace
}  // namespace pastoso::trace
