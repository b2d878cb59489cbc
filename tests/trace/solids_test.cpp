// Solids and milk in a tank of clear liquid.
#include "core/error.hpp"
#include "trace/scenes.hpp"
#include "trace/world.hpp"

#include <cmath>
#include <limits>

#include <gtest/gtest.h>

namespace pastoso::trace {
namespace {

constexpr glm::vec3 kMiddle_m(0.05F, 0.05F, 0.03F);
constexpr float kTop_m = 0.06F;

/// A tank full up to kTop_m, and a ball in the middle of the liquid.
Scene ball_in_a_tank(float radius_m = 0.015F) {
    Scene scene = tests::full_tank(kTop_m);
    if (radius_m > 0.0F) tests::add_ball(scene.solids, kMiddle_m, radius_m);
    return scene;
}

TEST(Solids, InAFurnaceShowTheirColour) {
    Scene scene;
    scene.cup.reset();
    scene.table.reset();
    tests::add_ball(scene.solids, glm::vec3(0.0F), 0.05F);
    tests::put_into_furnace(scene);
    scene.optics.solid_reflectance = {0.7F, 0.3F, 0.1F};
    scene.camera.eye_m = {0.0F, -1.0F, 0.0F};
    scene.camera.target_m = glm::vec3(0.0F);
    scene.camera.field_of_view_deg = 2.0F;  // within the ball
    core::ThreadPool pool(1);
    PathTracer tracer(scene, tests::small_picture(8), pool);
    tracer.add_samples(3);
    const Picture picture = tracer.radiance();
    // A ball that bulges everywhere meets its own light nowhere.
    for (std::size_t value = 0; value < picture.rgb.size(); ++value)
        EXPECT_NEAR(picture.rgb[value], scene.optics.solid_reflectance[static_cast<int>(value % 3)],
                    1e-6F);
}

TEST(Solids, InAFurnaceWithoutLossesATankWithMilkAndSolidsIsAsBrightAsTheSky) {
    Scene scene = ball_in_a_tank();
    scene.table = Table{};
    grid::BoxField share = tests::even_milk(0.0F);
    for (int j = 0; j < 16; ++j)
        for (int i = 0; i < 16; ++i)
            for (int k = 0; k < 6; ++k)
                share.at(i, j, k) = 0.01F;
    scene.milk_share = grid::BlockField(share);
    tests::put_into_furnace(scene);
    TraceSettings settings = tests::small_picture(12);
    settings.most_events = 100000;
    core::ThreadPool pool(1);
    PathTracer tracer(scene, settings, pool);
    tracer.add_samples(4);
    const Picture picture = tracer.radiance();
    // As for the glass of tea: rounding alone.
    EXPECT_NEAR(tests::mean_of(picture), 1.0, 2e-3);
    for (const float value : picture.rgb)
        EXPECT_LT(value, 1.001F);
}

TEST(Solids, LetNoLightThroughFromAirLiquidOrGlass) {
    const World with(ball_in_a_tank()), without(ball_in_a_tank(0.0F));
    Sampler sampler(1, 1, 1);
    std::uint64_t rays = 0;
    const struct {
        glm::vec3 from;
        unsigned here;
    } places[] = {
        {{-0.05F, 0.05F, 0.03F}, kAir},     // before the tank
        {{-0.001F, 0.05F, 0.03F}, kGlass},  // within its wall
        {{0.02F, 0.05F, 0.03F}, kLiquid},
        {{0.05F, 0.05F, 0.09F}, kAir},  // over the liquid
    };
    for (const auto& [from, here] : places) {
        const Ray ray = {from, glm::normalize(kMiddle_m - from)};
        EXPECT_EQ(with.straight_transmittance(ray, here, sampler, rays), glm::vec3(0.0F));
        const Ray past = {from, glm::normalize(kMiddle_m + glm::vec3(0.0F, 0.02F, 0.0F) - from)};
        EXPECT_EQ(with.straight_transmittance(past, here, sampler, rays),
                  without.straight_transmittance(past, here, sampler, rays));
        if (from.z > kTop_m) continue;  // under it is the table
        EXPECT_GT(without.straight_transmittance(ray, here, sampler, rays).g, 0.1F);  // but for tea
    }
}

TEST(Solids, AreMetWhereTheyReachIntoGlass) {
    Scene scene = ball_in_a_tank(0.0F);
    // A ball at the wall, which ends in the middle of it.
    tests::add_ball(scene.solids, {0.012F, 0.05F, 0.03F}, 0.013F, 40);
    const World world(scene);
    Sampler sampler(1, 1, 1);
    const Ray ray = {{-0.0019F, 0.05F, 0.03F}, {1.0F, 0.0F, 0.0F}};
    const World::Event event = world.next_event(ray, kGlass, sampler);
    EXPECT_EQ(event.hit.kind, SurfaceKind::Solid);
    EXPECT_NEAR(event.distance, 0.0009F, 2e-5F);  // facets cut off a little
}

TEST(MilkInATank, ScattersLightWhereThereIsLiquidAndNowhereElse) {
    Scene scene = ball_in_a_tank(0.0F);
    scene.milk_share =
        grid::BlockField(tests::even_milk(0.01F));  // above the liquid, too, and in the glass
    const World world(scene);
    constexpr int kRays = 20000;
    constexpr float kLength_m = 0.05F;
    int through = 0, above = 0, in_glass = 0;
    double way_m = 0.0;
    for (std::uint32_t i = 0; i < kRays; ++i) {
        Sampler sampler(7, i, 0);
        const World::Event event =
            world.next_event({{0.05F, 0.05F, kTop_m - kLength_m}, {0, 0, 1}}, kLiquid, sampler);
        if (!event.is_scattering) ++through;
        way_m += static_cast<double>(event.distance);
        above += world.next_event({{0.05F, 0.05F, 0.07F}, {1, 0, 0}}, kAir, sampler).is_scattering;
        in_glass +=
            world.next_event({{-0.001F, 0.05F, 0.03F}, {0, 1, 0}}, kGlass, sampler).is_scattering;
    }
    EXPECT_EQ(above, 0);
    EXPECT_EQ(in_glass, 0);
    // 0.01 of milk scatters 30 times a metre. Five standard errors; the way's is at most that of its
    // longest value.
    const double share = std::exp(-30.0 * static_cast<double>(kLength_m));
    EXPECT_NEAR(static_cast<double>(through) / kRays, share,
                5.0 * std::sqrt(share * (1.0 - share) / kRays));
    EXPECT_NEAR(way_m / kRays, (1.0 - share) / 30.0,
                5.0 * static_cast<double>(kLength_m) / std::sqrt(kRays));
}

TEST(MilkInATank, DimsStraightLightByItsShareOfTheLiquidAlone) {
    Scene scene = ball_in_a_tank(0.0F), cloudy = scene;
    cloudy.milk_share = grid::BlockField(tests::even_milk(0.01F));
    Sampler sampler(1, 1, 1);
    std::uint64_t rays = 0;
    const Ray level = {{-0.05F, 0.05F, 0.03F}, {1, 0, 0}}, above = {{-0.05F, 0.05F, 0.07F}, {1, 0, 0}};
    const World clear_world(scene), cloudy_world(cloudy);
    const float clear = clear_world.straight_transmittance(level, kAir, sampler, rays).g;
    // Even milk leaves to chance alone whether what is all but dark goes on.
    double sum = 0.0, squares = 0.0;
    constexpr int kRays = 4000;
    for (std::uint32_t i = 0; i < kRays; ++i) {
        Sampler chance(1, i, 1);
        const double share = static_cast<double>(
            cloudy_world.straight_transmittance(level, kAir, chance, rays).g / clear);
        sum += share / kRays;
        squares += share * share / kRays;
    }
    EXPECT_NEAR(sum, std::exp(-30.0 * 0.1), 5.0 * std::sqrt((squares - sum * sum) / kRays));
    EXPECT_EQ(cloudy_world.straight_transmittance(above, kAir, sampler, rays),
              clear_world.straight_transmittance(above, kAir, sampler, rays));
}

/// By rounding, a ray may slip between two triangles. Beyond the box the outermost cells' milk goes on,
/// of which there is none: nothing would ever end its way.
TEST(MilkInATank, IsNotLookedForOnAnEndlessWay) {
    Scene scene = ball_in_a_tank(0.0F);
    scene.table.reset();
    grid::BoxField share = tests::even_milk(0.0F);
    const grid::BoxShape& shape = share.shape();
    share.at(shape.nx - 2, shape.ny - 2, shape.nz - 2) = 1.0F;
    scene.milk_share = grid::BlockField(share);
    const Ray slipped = {{0.095F, 0.095F, 0.2F}, {0, 0, 1}};
    Sampler sampler(1, 1, 1);
    const World::Event event = World(scene).next_event(slipped, kLiquid, sampler);
    EXPECT_FALSE(event.is_scattering);
    EXPECT_EQ(event.hit.kind, SurfaceKind::None);
}

TEST(Solids, AreCheckedLikeOtherMeshes) {
    Scene scene = ball_in_a_tank();
    scene.solids.positions_m[3].y = std::numeric_limits<float>::quiet_NaN();
    EXPECT_THROW(check_scene(scene), core::InputError);
    scene = ball_in_a_tank();
    scene.optics.solid_reflectance.g = 1.5F;
    EXPECT_THROW(check_scene(scene), core::InputError);
}

}  // namespace
}  // namespace pastoso::trace
