#include "tank/liquid_tank.hpp"

#include "random_scenes.hpp"
#include "tank_cases.hpp"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

namespace pastoso::tank {
namespace {

using cases::block;
using cases::dam;

glm::dvec3 mean_place_m(const LiquidTank& tank) {
    glm::dvec3 sum(0.0);
    for (const Particle& particle : tank.particles())
        sum += glm::dvec3(particle.position_m);
    return sum / static_cast<double>(tank.particles().size());
}
double volume_m3(const LiquidTank& tank) {
    core::ThreadPool pool(1);
    return tank.volume_m3(pool);
}
double mean_speed2(const LiquidTank& tank) {
    double sum = 0.0;
    for (const Particle& particle : tank.particles()) {
        const glm::dvec3 u(particle.velocity_m_s);
        sum += glm::dot(u, u);
    }
    return sum / static_cast<double>(tank.particles().size());
}

TEST(LiquidTank, BeginsWithTheVolumeOfItsBodies) {
    TankScene scene = dam(24, {0.5F, 0.5F, 0.5F});
    EXPECT_NEAR(volume_m3(LiquidTank(scene)), 0.125, 1e-6);  // whole cells
    scene.liquids = {{{Sphere{{0.5F, 0.5F, 0.5F}, 0.3F}}, glm::vec3(0.0F), 0.0F}};
    const double ball_m3 = 4.0 / 3.0 * 3.14159265 * 0.027;
    // Places at random: thousands of particles on the border of the ball are in or out by chance.
    EXPECT_NEAR(volume_m3(LiquidTank(scene)), ball_m3, 0.01 * ball_m3);
}

TEST(LiquidTank, WhereBodiesMeetTheLaterOneCounts) {
    TankScene scene = dam(16, {1.0F, 1.0F, 0.5F});
    scene.liquids.push_back({block({0.5F, 0.0F, 0.0F}, {1.0F, 1.0F, 0.5F}), glm::vec3(0.0F), 1.0F});
    const LiquidTank tank(scene);
    EXPECT_EQ(tank.particles().size(), 16U * 16 * 8 * 8);
    for (const Particle& particle : tank.particles())
        ASSERT_EQ(particle.milk, particle.position_m.x >= 0.5F ? 1.0F : 0.0F);
}

/// Before it meets anything liquid falls as a stone does: first order in time, so half a step is lost.
TEST(LiquidTank, LiquidInTheAirFalls) {
    TankScene scene = dam(24, {0.1F, 0.1F, 0.1F});
    scene.liquids = {{{Sphere{{0.5F, 0.5F, 0.7F}, 0.15F}}, {0.4F, 0.0F, 0.0F}, 0.0F}};
    core::ThreadPool pool(2);
    LiquidTank tank(scene);
    const glm::dvec3 start_m = mean_place_m(tank);
    const double time_s = 0.2;
    const int steps = tank.advance_to(time_s, pool);
    const glm::dvec3 way_m = mean_place_m(tank) - start_m;
    const double fall_m = 0.5 * 9.81 * time_s * time_s;
    EXPECT_NEAR(way_m.x, 0.4 * time_s, 2e-4);
    EXPECT_NEAR(way_m.y, 0.0, 2e-4);
    EXPECT_NEAR(-way_m.z, fall_m * (1.0 + 1.0 / steps), 0.03 * fall_m);
    EXPECT_NEAR(tank.time_s(), time_s, 1e-9);
}

TEST(LiquidTank, APoolRests) {
    core::ThreadPool pool(2);
    LiquidTank tank(dam(20, {1.0F, 1.0F, 0.4F}));
    const double height_m = mean_place_m(tank).z;
    for (int step = 0; step < 100; ++step)
        tank.step(1.0, pool);
    EXPECT_NEAR(mean_place_m(tank).z, height_m, 0.01 * 0.4);
    // Particles lie at random, so that their surface is never quite level. A wave one cell high would
    // run with sqrt(9.81 x 0.4) x 0.05 / 0.4 = 0.25 m/s.
    EXPECT_LT(std::sqrt(mean_speed2(tank)), 0.05);
}

TEST(LiquidTank, KeepsEnergyInBounds) {
    core::ThreadPool pool(2);
    LiquidTank tank(dam(20, {0.4F, 1.0F, 0.8F}));
    const auto energy = [&] { return 0.5 * mean_speed2(tank) + 9.81 * mean_place_m(tank).z; };
    const double before = energy();
    double most = 0.0;
    for (int step = 0; step < 200; ++step) {
        tank.step(1.0, pool);
        most = std::max(most, energy());
    }
    EXPECT_LT(most, 1.03 * before);
    EXPECT_LT(energy(), 0.9 * before);
}

TEST(LiquidTank, ADrainEmptiesWhatLiesAboveIt) {
    TankScene scene = dam(20, {1.0F, 1.0F, 0.3F});
    scene.drains.push_back({block({0.4F, 0.4F, 0.0F}, {0.6F, 0.6F, 0.1F}), 0.1, 1e9});
    core::ThreadPool pool(2);
    LiquidTank tank(scene);
    tank.advance_to(0.09, pool);
    EXPECT_NEAR(volume_m3(tank), 0.3, 1e-6);  // still shut
    tank.advance_to(2.0, pool);
    const double half_m3 = volume_m3(tank);
    EXPECT_LT(half_m3, 0.15);
    tank.open_drains(false);
    tank.advance_to(2.2, pool);
    EXPECT_EQ(volume_m3(tank), half_m3);
    tank.open_drains(true);
    tank.advance_to(8.0, pool);
    EXPECT_LT(volume_m3(tank), 0.02);  // a film of less than half a cell
}

TEST(LiquidTank, ADrainShutsAtItsTime) {
    TankScene scene = dam(16, {1.0F, 1.0F, 0.3F});
    scene.drains.push_back({block({0.4F, 0.4F, 0.0F}, {0.6F, 0.6F, 0.1F}), 0.0, 0.2});
    core::ThreadPool pool(2);
    LiquidTank tank(scene);
    tank.advance_to(0.2, pool);
    const double left_m3 = volume_m3(tank);
    EXPECT_LT(left_m3, 0.29);
    tank.advance_to(0.5, pool);
    EXPECT_EQ(volume_m3(tank), left_m3);
}

TEST(LiquidTank, WindPushesWhereItPoints) {
    core::ThreadPool pool(2);
    for (const double direction_deg : {0.0, 90.0, 225.0}) {
        TankScene scene = dam(16, {1.0F, 1.0F, 0.4F});
        scene.wind = {6.0, direction_deg, 4.0, 0.0, 1e9};
        LiquidTank tank(scene);
        const glm::dvec3 before_m = mean_place_m(tank);
        tank.advance_to(0.3, pool);
        const glm::dvec3 way_m = mean_place_m(tank) - before_m;
        const double angle = direction_deg * 3.14159265 / 180.0;
        const double along_m = way_m.x * std::cos(angle) + way_m.y * std::sin(angle);
        const double across_m = -way_m.x * std::sin(angle) + way_m.y * std::cos(angle);
        EXPECT_GT(along_m, 0.002) << direction_deg;
        EXPECT_LT(std::abs(across_m), 0.25 * along_m) << direction_deg;
    }
}

TEST(LiquidTank, ASolidStaysDry) {
    TankScene scene = dam(24, {0.3F, 1.0F, 0.7F});
    const Sphere ball = {{0.6F, 0.5F, 0.2F}, 0.18F};
    scene.solids.push_back({ball});
    core::ThreadPool pool(2);
    LiquidTank tank(scene);
    for (int frame = 1; frame <= 10; ++frame) {
        tank.advance_to(0.1 * frame, pool);
        for (const Particle& particle : tank.particles())
            ASSERT_GT(glm::distance(particle.position_m, ball.centre_m),
                      ball.radius_m - 0.1F / 24.0F);  // distances are interpolated between cells
    }
    EXPECT_NEAR(volume_m3(tank), 0.3 * 0.7, 0.01 * 0.21);
}

TEST(LiquidTank, AJetFillsTheTank) {
    TankScene scene = dam(20, glm::vec3(0.0F));
    scene.liquids.clear();
    scene.viscosity_m2_s = 0.05;
    const double area_m2 = 0.2 * 0.2, speed_m_s = 1.5, time_s = 0.8;
    scene.jets.push_back(
        {block({0.4F, 0.4F, 0.85F}, {0.6F, 0.6F, 1.0F}), {0.0F, 0.0F, -1.5F}, 1.0F, 0.0, time_s});
    core::ThreadPool pool(2);
    LiquidTank tank(scene);
    tank.advance_to(time_s, pool);
    EXPECT_TRUE(cases::is_sound(tank, pool));
    const double poured_m3 = area_m2 * (speed_m_s * time_s + 0.15);
    EXPECT_NEAR(volume_m3(tank), poured_m3, 0.15 * poured_m3);
    const double full_m3 = volume_m3(tank);
    tank.advance_to(time_s + 0.2, pool);
    EXPECT_EQ(volume_m3(tank), full_m3);
}

TEST(LiquidTank, ASphereAddedLeavesWhatIsThere) {
    core::ThreadPool pool(2);
    LiquidTank tank(dam(16, {1.0F, 1.0F, 0.5F}));
    const std::size_t before = tank.particles().size();
    tank.add({{Sphere{{0.5F, 0.5F, 0.5F}, 0.2F}}, glm::vec3(0.0F), 1.0F}, pool);
    const double added_m3 = static_cast<double>(tank.particles().size() - before) / 8.0 / 4096.0;
    const double half_ball_m3 = 2.0 / 3.0 * 3.14159265 * 0.008;
    EXPECT_NEAR(added_m3, half_ball_m3, 0.1 * half_ball_m3);
    tank.advance_to(0.2, pool);
    EXPECT_TRUE(cases::is_sound(tank, pool));
}

TEST(LiquidTank, IsTheSameOnAnyNumberOfThreads) {
    TankScene scene = dam(18, {0.4F, 1.0F, 0.6F});
    scene.solids.push_back({Sphere{{0.7F, 0.5F, 0.2F}, 0.15F}});
    scene.wind = {3.0, 30.0, 4.0, 0.0, 1e9};
    core::ThreadPool single(1), several(3);
    LiquidTank a(scene), b(scene);
    a.advance_to(0.4, single);
    b.advance_to(0.4, several);
    EXPECT_TRUE(std::ranges::equal(a.particles(), b.particles()));
    EXPECT_EQ(a.velocity(), b.velocity());
}

TEST(LiquidTank, RandomScenesStayFinite) {
    cases::run_random_scenes(0, 60);
}

}  // namespace
}  // namespace pastoso::tank
