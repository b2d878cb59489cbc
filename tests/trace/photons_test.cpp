#include "trace/photons.hpp"

#include "trace/scenes.hpp"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

namespace pastoso::trace {
namespace {

PhotonMaps shot(const Scene& scene, int threads = 2) {
    core::ThreadPool pool(threads);
    const TraceSettings settings = tests::small_picture(400);
    return shoot_photons(World(scene), settings, pool).value();
}

Scene cloudy_tea(float share) {
    Scene scene;
    scene.milk_share = grid::BlockField(tests::even_milk(share));
    return scene;
}

constexpr float kSphere = 4.0F * std::numbers::pi_v<float>;

/// Where nothing is lost, light is the same everywhere and from everywhere.
TEST(Photons, InAFurnaceFluenceIsThatOfTheSky) {
    Scene scene = cloudy_tea(0.2F);
    tests::put_into_furnace(scene);
    scene.table.reset();
    const PhotonMaps maps = shot(scene);
    double sum = 0.0;
    int places = 0;
    for (float z = 0.01F; z < 0.085F; z += 0.005F)
        for (float x = 0.03F; x < 0.071F; x += 0.005F) {
            const double share = static_cast<double>(maps.fluence.at({x, 0.05F, z}).g / kSphere);
            EXPECT_NEAR(share, 1.0, 0.25) << x << " " << z;  // five times the scatter
            sum += share;
            ++places;
        }
    // What is caught between totally reflecting walls is carried by few.
    EXPECT_NEAR(sum / places, 1.0, 0.03);
}

TEST(Photons, LeaveTheSameOnAnyNumberOfThreads) {
    const Scene scene = cloudy_tea(0.05F);
    const PhotonMaps one = shot(scene, 1), three = shot(scene, 3);
    for (float z = 0.01F; z < 0.085F; z += 0.007F)
        EXPECT_EQ(one.fluence.at({0.04F, 0.05F, z}), three.fluence.at({0.04F, 0.05F, z}));
    for (float x = -0.1F; x < 0.2F; x += 0.013F)
        EXPECT_EQ(one.caustics.irradiance({x, 0.1F}), three.caustics.irradiance({x, 0.1F}));
}

/// Beside the glass, where it throws its shadow and what light it gathers: by the photons as by paths
/// that meet the lamp by chance.
TEST(Photons, TheTableIsAsBrightAsByChance) {
    Scene scene;
    scene.camera.eye_m = {0.11F, 0.11F, 0.5F};
    scene.camera.target_m = {0.11F, 0.11F, 0.0F};
    scene.camera.field_of_view_deg = 8.0F;
    scene.lamp->radius_deg = 25.0F;
    scene.lamp->radiance = glm::vec3(8.0F);
    const auto mean = [&](bool seeks, int samples) {
        TraceSettings settings = tests::small_picture(24);
        settings.seeks_lamp = seeks;
        settings.brightest = 1e6F;
        core::ThreadPool pool(2);
        PathTracer tracer(scene, settings, pool);
        tracer.add_samples(samples);
        return tests::mean_of(tracer.radiance());
    };
    const double reference = mean(false, 1024);
    EXPECT_NEAR(mean(true, 64) / reference, 1.0, 0.03);
}

TEST(Photons, WithoutLampOrMilkThereIsNothingToLeave) {
    Scene dark;
    dark.lamp.reset();
    const PhotonMaps maps = shot(dark);
    EXPECT_TRUE(maps.fluence.empty());
    EXPECT_EQ(maps.caustics.irradiance({0.1F, 0.1F}), glm::vec3(0.0F));
    Scene bare;
    bare.cup.reset();
    EXPECT_TRUE(shot(bare).caustics.empty());
}

TEST(Photons, StopWhenToldTo) {
    core::ThreadPool pool(2);
    const TraceSettings settings = tests::small_picture(200);
    EXPECT_FALSE(shoot_photons(World(cloudy_tea(0.01F)), settings, pool, [] { return true; }));
}

/// Places on the hull lie on the cup's outer wall, lip and foot, as often as each has of the area.
TEST(CupSurfaces, PlacesOnTheHullAreEvenOverItsArea) {
    const liquid::Cup cup;
    const CupSurfaces surfaces(cup);
    const double foot = cup.inner_radius_m(cup.foot_m) + cup.wall_m,
                 rim = cup.inner_radius_m(cup.rim_m) + cup.wall_m, height = cup.rim_m - cup.foot_m;
    const double wall = std::numbers::pi * (foot + rim) * std::hypot(height, rim - foot);
    const double area = wall + std::numbers::pi * (foot * foot + rim * rim);
    EXPECT_NEAR(static_cast<double>(surfaces.hull_area_m2()) / area, 1.0, 1e-5);
    constexpr int kPlaces = 20000;
    int on_wall = 0, on_lip = 0;
    double wall_height = 0.0;
    for (std::uint32_t i = 0; i < kPlaces; ++i) {
        Sampler sampler(3, 0, i);
        const float which = sampler.next();
        const auto [place, outward] = surfaces.hull_place(which, sampler.pair());
        const float radius = glm::length(glm::vec2(place) - cup.axis_m);
        EXPECT_NEAR(glm::length(outward), 1.0F, 1e-5F);
        if (std::abs(outward.z) == 1.0F) {
            EXPECT_LE(radius, outward.z > 0.0F ? rim + 1e-6 : foot + 1e-6);
            on_lip += outward.z > 0.0F ? 1 : 0;
            continue;
        }
        ++on_wall;
        wall_height += place.z - cup.foot_m;
        EXPECT_NEAR(radius, cup.inner_radius_m(place.z) + cup.wall_m, 1e-6F);
        EXPECT_GT(glm::dot(outward, place - glm::vec3(cup.axis_m, place.z)), 0.0F);
    }
    const auto expect_share = [&](int count, double share) {
        EXPECT_NEAR(count / static_cast<double>(kPlaces), share,
                    5.0 * std::sqrt(share * (1.0 - share) / kPlaces));
    };
    expect_share(on_wall, wall / area);
    expect_share(on_lip, std::numbers::pi * rim * rim / area);
    const double mean_height = height * (foot + 2.0 * rim) / (3.0 * (foot + rim));
    EXPECT_NEAR(wall_height / on_wall / mean_height, 1.0, 0.02);
}

}  // namespace
}  // namespace pastoso::trace
