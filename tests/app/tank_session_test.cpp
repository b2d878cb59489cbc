// A tank of liquid on a thread of its own, and what is kept of it.
#include "session/tank_session.hpp"

#include "liquid_files/tank_json.hpp"
#include "patience.hpp"
#include "session/far_level.hpp"
#include "session/liquid_picture.hpp"
#include "trace/tank_scene.hpp"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

namespace pastoso::session {
namespace {

/// A quarter full, and small enough for a test.
tank::TankScene small_tank() {
    tank::TankScene scene;
    scene.cells = {16, 16, 16};
    scene.cell_m = 0.01;
    scene.liquids.push_back({.shape = {tank::Block{glm::vec3(-0.1F), glm::vec3(0.3F, 0.3F, 0.04F)}}});
    return scene;
}

void wait_for_moment(const TankSession& session, int step) {
    ASSERT_TRUE(tests::comes_true([&] { return session.status().last_step >= step; }));
}

/// So many moments, whatever the clock says.
void advance(TankSession& session, int moments) {
    session.advance(moments);
    session.wait_until_applied();
}

TEST(TankSession, LiquidIsThereAndTimePasses) {
    TankSession session(small_tank(), true, [] {});
    advance(session, 5);
    const TankStatus status = session.status();
    EXPECT_EQ(status.last_step, 5);
    EXPECT_TRUE(status.paused);
    // Sixteen cells a side, four of them full, eight drops to each: exactly what the scene says.
    EXPECT_NEAR(status.volume_m3, 0.16 * 0.16 * 0.04, 1e-9);
    const auto snapshot = session.snapshot();
    ASSERT_NE(snapshot, nullptr);
    EXPECT_EQ(snapshot->seen.step, 5);
    EXPECT_NEAR(rest_level_m(*snapshot), 0.04F, 1e-6F);
    // Moments are equally far apart, whatever the steps were.
    for (const int step : status.kept)
        EXPECT_NEAR(session.kept().frames.at(step).time_s, step * kTankMoment_s, 1e-6);
}

TEST(TankSession, TimePassesByItselfUnlessItIsPaused) {
    TankSession session(small_tank(), false, [] {});
    wait_for_moment(session, 1);
    session.set_full_speed(true);
    wait_for_moment(session, 5);
    session.set_paused(true);
    session.wait_until_applied();
    EXPECT_TRUE(session.status().paused);
    EXPECT_EQ(session.snapshot()->seen.step, session.status().last_step);
}

TEST(TankSession, WhatIsSaidIsSaidOfWhatIsSeen) {
    TankSession session(small_tank(), false, [] {});
    session.set_full_speed(true);
    session.wait_until_applied();
    for (int seen = 0; seen < 12;) {
        const TankSession::Published published = session.published();
        ASSERT_EQ(published.status.step, published.snapshot->seen.step);
        seen = published.status.step;
    }
}

TEST(TankSession, TheSurfaceHoldsTheLiquidWithinTheTank) {
    TankSession session(small_tank(), true, [] {});
    session.wait_until_applied();
    core::ThreadPool pool;
    const auto snapshot = session.snapshot();
    const liquid::TriangleMesh mesh = liquid_surface(*snapshot->place, snapshot->seen, 0.0F, pool);
    // Samples a cell apart cut the edges off, and see the level a third of a cell too low: one twelfth
    // of four cells.
    EXPECT_NEAR(liquid::volume_m3(mesh), snapshot->seen.volume_m3, 0.1 * snapshot->seen.volume_m3);
    for (const glm::vec3& at_m : mesh.positions_m)
        for (const int axis : {0, 1, 2}) {
            EXPECT_GT(at_m[axis], -1e-5F);
            EXPECT_LT(at_m[axis], 0.16F + 1e-5F);
        }
}

TEST(TankSession, ASphereAddsItsVolumeAndItsMilk) {
    TankSession session(small_tank(), true, [] {});
    session.wait_until_applied();
    const double before_m3 = session.status().volume_m3;
    session.add_sphere({{0.08F, 0.08F, 0.11F}, 0.03F}, 1.0F);
    session.wait_until_applied();
    const double sphere_m3 = 4.0 / 3.0 * 3.14159265 * 0.03 * 0.03 * 0.03;
    // Drops of half a cell's side: 2 cells deep, its surface is known to a tenth of its volume.
    EXPECT_NEAR(session.status().volume_m3 - before_m3, sphere_m3, 0.1 * sphere_m3);
    EXPECT_GT(session.snapshot()->seen.milk.at(8, 8, 11), 0.9F);
    EXPECT_EQ(session.snapshot()->seen.milk.at(8, 8, 1), 0.0F);
}

TEST(TankSession, TheDrainEmptiesTheTankWhileItIsOpen) {
    TankSession session(small_tank(), true, [] {});
    advance(session, 4);
    EXPECT_FALSE(session.status().drains_open);
    const double full_m3 = session.status().volume_m3;
    EXPECT_NEAR(full_m3, 0.16 * 0.16 * 0.04, 1e-9);
    session.open_drains(true);
    // Half of it falls through the hole in less than a second; two are enough.
    for (int snapshot = 0; snapshot < 120 && session.status().volume_m3 > 0.5 * full_m3; ++snapshot)
        advance(session, 1);
    EXPECT_LT(session.status().volume_m3, 0.5 * full_m3);
    session.open_drains(false);
    session.wait_until_applied();
    const double left_m3 = session.status().volume_m3;
    advance(session, 3);
    EXPECT_EQ(session.status().volume_m3, left_m3);
    EXPECT_FALSE(session.status().drains_open);
}

TEST(TankSession, TheDrainIsBesideWhatStandsThere) {
    const tank::TankScene scene = with_drain(liquid_files::read_tank("two-liquids"));
    ASSERT_EQ(scene.drains.size(), 1U);
    const auto& drain = std::get<tank::Cylinder>(scene.drains[0].shape.form);
    for (const tank::Shape& solid : scene.solids)
        EXPECT_GT(tank::ShapeDistance(solid)(drain.to_m), drain.radius_m);
    EXPECT_EQ(with_drain(scene), scene);
}

TEST(TankSession, TheWindMovesTheLiquidWhereItBlows) {
    for (const double direction_deg : {0.0, 180.0}) {
        TankSession session(small_tank(), true, [] {});
        TankWind wind;
        wind.on = true;
        wind.direction_deg = direction_deg;
        wind.speed_m_s = 5.0;
        wind.drag_per_s = 50.0;
        session.set_wind(wind);
        advance(session, 2);
        EXPECT_EQ(session.status().wind, wind);
        // The surface drifts along, before it has come to the wall; below it the liquid comes back, more
        // slowly than it.
        double fastest_m_s = 0.0;
        for (const FlowArrow& arrow : session.snapshot()->seen.arrows)
            if (std::abs(static_cast<double>(arrow.velocity_m_s.x)) > std::abs(fastest_m_s))
                fastest_m_s = static_cast<double>(arrow.velocity_m_s.x);
        EXPECT_GT(fastest_m_s * (direction_deg == 0.0 ? 1.0 : -1.0), 0.02);
    }
}

/// Without gravity a ball stays where it is; with it it would fall by five cells in that time.
TEST(TankSession, NumbersChangeWhileTimePasses) {
    TankSession session(small_tank(), true, [] {});
    tank::TankScene numbers = small_tank();
    numbers.gravity_m_s2 = 0.0;
    session.set_numbers(numbers);
    session.add_sphere({{0.08F, 0.08F, 0.11F}, 0.03F}, 1.0F);
    advance(session, 6);
    EXPECT_GT(session.snapshot()->seen.milk.at(8, 8, 11), 0.9F);
}

TEST(TankSession, WhatCannotBeIsToldAndChangesNothing) {
    TankSession session(small_tank(), true, [] {});
    session.wait_until_applied();
    TankWind wind;
    wind.on = true;
    wind.speed_m_s = -1.0;
    session.set_wind(wind);
    tank::TankScene numbers = small_tank();
    numbers.viscosity_m2_s = -1.0;
    session.set_numbers(numbers);
    session.add_sphere({{0.08F, 0.08F, 0.1F}, -1.0F}, 0.0F);
    tank::TankScene bad = small_tank();
    bad.cells = {1, 1, 1};
    session.new_tank(bad);
    session.wait_until_applied();
    EXPECT_EQ(session.take_errors().size(), 4U);
    EXPECT_FALSE(session.status().wind.on);
    EXPECT_EQ(session.status().glass, 1);
    EXPECT_FALSE(session.status().busy);
    EXPECT_NEAR(session.status().volume_m3, 0.16 * 0.16 * 0.04, 1e-9);
}

TEST(TankSession, AnyMomentIsShownAgainAndTheLastGoesOn) {
    TankSession session(small_tank(), true, [] {});
    session.advance(8);
    session.show(3);
    session.wait_until_applied();
    EXPECT_TRUE(session.status().paused);
    EXPECT_FALSE(session.status().shows_last);
    EXPECT_EQ(session.snapshot()->seen.step, 3);
    const int last = session.status().last_step;
    session.set_paused(false);
    wait_for_moment(session, last + 1);
    EXPECT_TRUE(session.status().shows_last);
}

/// The moment that waits at that step, when it has come.
std::shared_ptr<const TankSnapshot> waiting_moment(const TankSession& session, int step) {
    const auto waits = [&] {
        const auto snapshot = session.snapshot();
        return snapshot != nullptr && snapshot->waits && snapshot->seen.step == step ? snapshot
                                                                                     : nullptr;
    };
    return tests::comes_true([&] { return waits() != nullptr; }) ? waits() : nullptr;
}

TEST(TankSession, EveryMomentWaitsUntilItIsTaken) {
    TankSession session(small_tank(), false, [] {});
    session.set_waiting(true);
    session.set_full_speed(true);
    session.wait_until_applied();
    const int first = session.status().last_step + (session.snapshot()->waits ? 0 : 1);
    for (int step = first; step < first + 4; ++step) {
        const auto snapshot = waiting_moment(session, step);
        ASSERT_NE(snapshot, nullptr) << step;
        EXPECT_NEAR(snapshot->seen.time_s, step * kTankMoment_s, 1e-6);
        session.take(snapshot);
    }
    // Another one is none that waits.
    const auto last = waiting_moment(session, first + 4);
    ASSERT_NE(last, nullptr);
    TankSnapshot other = *last;
    other.seen.step = first;
    session.take(std::make_shared<const TankSnapshot>(other));
    session.add_sphere({{0.08F, 0.08F, 0.12F}, 0.03F}, 0.0F);
    session.wait_until_applied();
    EXPECT_EQ(session.snapshot()->seen.step, first + 4);
    EXPECT_TRUE(session.snapshot()->waits);
    EXPECT_GT(session.status().volume_m3, last->seen.volume_m3 + 1e-5);
    session.set_waiting(false);
    wait_for_moment(session, first + 8);
    EXPECT_FALSE(session.snapshot()->waits);
}

/// In a model of the usual size, seen from where the window sees it.
TEST(TankSession, APictureShowsTheTankAsItIsSeen) {
    TankSession session(small_tank(), true, [] {});
    session.wait_until_applied();
    core::ThreadPool pool;
    trace::Camera camera;
    camera.eye_m = {0.3F, -0.5F, 0.2F};
    camera.target_m = {0.08F, 0.08F, 0.07F};
    camera.field_of_view_deg = 31.0F;
    const trace::Scene scene = traced_tank(*session.snapshot(), camera, pool);
    const float model = trace::kTankModel_m / 0.16F;
    EXPECT_NEAR(glm::distance(scene.camera.eye_m, model * camera.eye_m), 0.0F, 1e-6F);
    EXPECT_NEAR(glm::distance(scene.camera.target_m, model * camera.target_m), 0.0F, 1e-6F);
    EXPECT_EQ(scene.camera.field_of_view_deg, 31.0F);
    ASSERT_TRUE(scene.tank.has_value());
    EXPECT_NEAR(scene.tank->inner_high_m.x, trace::kTankModel_m, 1e-6F);
    // It reaches into the glass below it, so that no gap is seen, by a quarter of a cell at most.
    float lowest_m = 1.0F;
    for (const glm::vec3& at_m : scene.clear_liquid.positions_m)
        lowest_m = std::min(lowest_m, at_m.z);
    EXPECT_LT(lowest_m, 0.0F);
    EXPECT_GT(lowest_m, -0.251F * 0.01F * model);
    EXPECT_TRUE(scene.solids.positions_m.empty());
    EXPECT_NO_THROW(trace::check_scene(scene));
}

TEST(TankSession, StartingAgainBeginsAtNothing) {
    TankSession session(small_tank(), true, [] {});
    session.open_drains(true);
    session.advance(4);
    session.new_tank(small_tank());
    session.wait_until_applied();
    const TankStatus status = session.status();
    EXPECT_EQ(status.last_step, 0);
    EXPECT_EQ(status.glass, 2);
    EXPECT_FALSE(status.drains_open);
    EXPECT_EQ(status.kept, std::vector<int>{0});
    EXPECT_NEAR(status.volume_m3, 0.16 * 0.16 * 0.04, 1e-9);
}

/// In the middle of what it computes.
TEST(TankSession, EndsAtOnce) {
    for (int i = 0; i < 3; ++i) {
        TankSession session(small_tank(), false, [] {});
        session.set_full_speed(true);
    }
}

/// A ball whose level is known near its surface alone.
TEST(FarLevel, GoesOnWithoutReachingBeyondTheSurface) {
    const liquid::Lattice lattice{24, 24, 24, 0.01F, glm::vec3(0.0F)};
    liquid::SampledField level_m(lattice);
    const auto ball_m = [&](int i, int j, int k) {
        return glm::length(lattice.point_m(i, j, k) - glm::vec3(0.11F)) - 0.06F;
    };
    for (int k = 0; k < 24; ++k)
        for (int j = 0; j < 24; ++j)
            for (int i = 0; i < 24; ++i)
                level_m.at(i, j, k) = std::clamp(ball_m(i, j, k), -0.004F, 0.011F);
    const liquid::SampledField far_m = far_level(level_m);
    for (int k = 0; k < 24; ++k)
        for (int j = 0; j < 24; ++j)
            for (int i = 0; i < 24; ++i) {
                const float true_m = ball_m(i, j, k), found_m = far_m.at(i, j, k);
                EXPECT_EQ(found_m < 0.0F, true_m < 0.0F);
                // A tenth of a cell: the ball's surface bends within one.
                EXPECT_LE(std::abs(found_m), std::abs(true_m) + 0.001F);
                // Beside the surface the level is known to 0.4 of a cell, where it is up to a whole one.
                EXPECT_GE(std::abs(found_m), 0.57F * std::abs(true_m) - 0.003F);
            }
}

TEST(TankFrames, GiveBackWhatTheyKept) {
    const grid::BoxShape shape{6, 5, 4, 0.01F};
    TankSeen seen{0,
                  0.25,
                  1e-3,
                  liquid::SampledField(tank::frame_lattice(shape, 1), 0.011F),
                  grid::BoxField(shape),
                  {{glm::vec3(0.01F), glm::vec3(0.5F)}}};
    seen.level_m.at(3, 2, 1) = -0.004F;
    seen.milk.at(1, 2, 3) = 0.5F;
    TankFrames frames(1 << 20);
    frames.keep(seen);
    const TankSeen back = frames.at(7);
    EXPECT_EQ(back.time_s, 0.25);
    EXPECT_EQ(back.volume_m3, 1e-3);
    // Half a step of each.
    EXPECT_NEAR(back.level_m.at(3, 2, 1), -0.004F, 0.5F * 0.01F / 8000.0F + 1e-9F);
    EXPECT_NEAR(back.level_m.at(0, 0, 0), 0.011F, 0.5F * 0.01F / 8000.0F + 1e-9F);
    EXPECT_NEAR(back.milk.at(1, 2, 3), 0.5F, 0.5F / 255.0F + 1e-6F);
    ASSERT_EQ(back.arrows.size(), 1U);
    EXPECT_EQ(back.arrows[0].velocity_m_s, glm::vec3(0.5F));
    EXPECT_LT(frames.bytes(), 1000U);
}

}  // namespace
}  // namespace pastoso::session
