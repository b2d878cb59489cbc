#include "trace/vessel.hpp"

#include "core/random.hpp"
#include "trace/optics.hpp"
#include "trace/scenes.hpp"
#include "trace/world.hpp"

#include <gtest/gtest.h>

namespace pastoso::trace {
namespace {

glm::vec3 random_direction(std::uint32_t index) {
    const float z = 1.0F - 2.0F * core::uniform_noise(index, 1);
    const glm::vec2 turn = cos_sin_of_turns(core::uniform_noise(index, 2)) * std::sqrt(1.0F - z * z);
    return {turn, z};
}

TEST(CupSurfaces, RaysOutOfTheTeaEndWhereItsDistanceIsZero) {
    const liquid::Cup cup;
    const CupSurfaces surfaces(cup);
    for (std::uint32_t i = 0; i < 2000; ++i) {
        const Ray ray{{0.06F, 0.045F, 0.03F}, random_direction(i)};
        SurfaceHit hit;
        surfaces.meet(ray, kLiquid, hit);
        ASSERT_EQ(hit.kind, SurfaceKind::Clear);
        // Rounding of coordinates of 0.1 m.
        EXPECT_NEAR(liquid::tea_distance_m(cup, ray.origin + ray.direction * hit.distance), 0.0F, 1e-7F);
        EXPECT_NEAR(glm::length(hit.normal), 1.0F, 1e-6F);
        const bool through_level = hit.normal.z > 0.5F && ray.direction.z > 0.0F;
        EXPECT_EQ(hit.beyond(kLiquid, ray.direction), through_level ? kAir : kGlass);
    }
}

TEST(CupSurfaces, RaysThatCrossTheWholeGlassEndInAir) {
    const CupSurfaces surfaces{liquid::Cup()};
    int crossed = 0;
    for (std::uint32_t i = 0; i < 2000; ++i) {
        Ray ray{glm::vec3(0.05F, 0.05F, 0.04F) - 0.4F * random_direction(i), random_direction(i)};
        ray.origin += 0.04F * random_direction(i + 5000);
        unsigned here = kAir;
        for (int crossing = 0; crossing < 20; ++crossing) {
            SurfaceHit hit;
            surfaces.meet(ray, here, hit);
            if (hit.kind == SurfaceKind::None) break;
            ++crossed;
            here = hit.beyond(here, ray.direction);
            ray.origin += ray.direction * hit.distance;
        }
        EXPECT_EQ(here, kAir) << i;
    }
    EXPECT_GT(crossed, 2000);
}

/// Bends a ray at every clear surface until it is out.
Ray sent_through(const World& world, Ray ray) {
    unsigned here = kAir;
    Sampler sampler(1, 1, 1);
    for (;;) {
        const World::Event event = world.next_event(ray, here, sampler);
        if (event.hit.kind != SurfaceKind::Clear) return ray;
        const unsigned beyond = event.hit.beyond(here, ray.direction);
        const glm::vec3& n = event.hit.normal;
        const glm::vec3 facing = glm::dot(n, ray.direction) > 0.0F ? -n : n;
        ray.origin += ray.direction * event.distance - facing * 1e-6F;
        ray.direction = refracted(ray.direction, facing,
                                  world.refractive_index(here) / world.refractive_index(beyond));
        here = beyond;
    }
}

TEST(TankSurfaces, RaysLeaveAnEmptyTankOfPlatesAsTheyCame) {
    Scene scene;
    scene.cup.reset();
    scene.table.reset();
    scene.tank = Tank{};
    const World world(scene);
    for (std::uint32_t i = 0; i < 200; ++i) {
        // Level enough to pass through two opposite walls.
        const glm::vec3 direction = glm::normalize(glm::vec3(
            1.0F, 0.5F * core::uniform_noise(i, 3) - 0.25F, 0.5F * core::uniform_noise(i, 4) - 0.25F));
        const Ray out = sent_through(world, {glm::vec3(0.05F) - direction * 0.3F, direction});
        EXPECT_GT(out.origin.x, 0.101F);
        EXPECT_NEAR(glm::distance(out.direction, direction), 0.0F, 2e-6F);
    }
}

TEST(TankSurfaces, APlateShiftsARayByWhatGeometrySays) {
    Scene scene;
    scene.cup.reset();
    scene.table.reset();
    scene.tank = Tank{};
    const World world(scene);
    const float sine = 0.5F;
    const glm::vec3 direction(std::sqrt(1.0F - sine * sine), sine, 0.0F);
    const Ray out = sent_through(world, {{-0.05F, 0.005F, 0.05F}, direction});
    // Each of two plates d thick moves it aside by d (tan a - tan b).
    const float inner_sine = sine / 1.5F;
    const float tangent = sine / std::sqrt(1.0F - sine * sine);
    const float inner_tangent = inner_sine / std::sqrt(1.0F - inner_sine * inner_sine);
    const float straight = 0.005F + tangent * (out.origin.x + 0.05F);
    EXPECT_NEAR(straight - out.origin.y, 2.0F * 0.002F * (tangent - inner_tangent), 1e-5F);
}

TEST(TankSurfaces, ALiquidThatReachesIntoTheGlassIsGlassThere) {
    const World world(tests::full_tank(0.06F));
    Sampler sampler(1, 1, 1);
    Ray ray{{-0.05F, 0.05F, 0.03F}, {1, 0, 0}};
    unsigned here = kAir;
    std::vector<float> indices;
    for (int crossing = 0; crossing < 6; ++crossing) {
        const World::Event event = world.next_event(ray, here, sampler);
        ASSERT_EQ(event.hit.kind, SurfaceKind::Clear);
        here = event.hit.beyond(here, ray.direction);
        ray.origin += ray.direction * event.distance;
        indices.push_back(world.refractive_index(here));
    }
    EXPECT_EQ(indices, (std::vector<float>{1.5F, 1.5F, 1.335F, 1.5F, 1.5F, 1.0F}));
}

/// From all sides, above and below, rays end on the dented level, and its normal is that of its height.
TEST(CupSurfaces, RaysMeetTheLevelInItsDents) {
    const liquid::Cup cup;
    const LevelDent deep{{0.045F, 0.055F}, 0.0015F, 0.006F}, shallow{{0.06F, 0.05F}, 0.0006F, 0.004F};
    const CupSurfaces surfaces(cup, {deep, shallow});
    const auto height_m = [&](const glm::vec2& place_m) {
        float height = cup.level_m;
        for (const LevelDent& dent : {deep, shallow}) {
            const glm::vec2 from = (place_m - dent.at_m) / dent.radius_m;
            height -= dent.depth_m * std::exp(-glm::dot(from, from));
        }
        return height;
    };
    int met = 0;
    for (std::uint32_t i = 0; i < 4000; ++i) {
        const glm::vec3 way = random_direction(i);
        if (std::abs(way.z) < 0.2F) continue;  // all but level, where a dent is met twice
        const glm::vec2 aside = 0.01F * glm::vec2(random_direction(i + 9000));
        const Ray ray{glm::vec3(deep.at_m + aside, cup.level_m) - 0.01F * way, way};
        const unsigned here = way.z < 0.0F ? kAir : kLiquid;
        SurfaceHit hit;
        surfaces.meet(ray, here, hit);
        if (hit.kind != SurfaceKind::Clear || hit.normal.z < 0.5F) continue;
        const glm::vec3 at = ray.origin + ray.direction * hit.distance;
        if (at.z < cup.level_m - 0.0025F) continue;  // the floor
        ++met;
        EXPECT_NEAR(at.z, height_m(glm::vec2(at)), 2e-6F);
        const float step_m = 1e-4F;
        const glm::vec2 x(step_m, 0.0F), y(0.0F, step_m), place(at);
        const glm::vec2 slope(height_m(place + x) - height_m(place - x),
                              height_m(place + y) - height_m(place - y));
        EXPECT_GT(glm::dot(hit.normal, glm::normalize(glm::vec3(-slope / (2.0F * step_m), 1.0F))),
                  0.999F);
        EXPECT_EQ(hit.beyond(here, way), way.z < 0.0F ? kLiquid : kAir);
    }
    EXPECT_GT(met, 3000);
    // What is said to be free of surfaces is.
    EXPECT_LE(surfaces.clearance_m({deep.at_m, cup.level_m - 0.004F}), 0.004F - deep.depth_m);
}

}  // namespace
}  // namespace pastoso::trace
