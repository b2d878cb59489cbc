// A glass of milk tea on a thread of its own, and what is kept of it.
#include "session/tea_session.hpp"

#include "core/message_text.hpp"
#include "patience.hpp"
#include "session/liquid_picture.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include <gtest/gtest.h>

namespace pastoso::session {
namespace {

/// Small enough for a test: nothing rises in it, but all that is tested here happens.
liquid::TeaSettings small_glass() {
    liquid::TeaSettings settings;
    settings.cells = 16;
    settings.parcels = 400;
    settings.pour_s = 0.2;
    return settings;
}

void wait_for_step(const TeaSession& session, int step) {
    ASSERT_TRUE(tests::comes_true([&] { return session.status().last_step >= step; }));
}

/// So many steps, whatever the clock says.
void advance(TeaSession& session, int steps) {
    session.advance(steps);
    session.wait_until_applied();
}

TEST(TeaSession, PoursTheMilkOfTheRecipe) {
    TeaSession session(small_glass(), true, [] {});
    session.pour_recipe(true);
    advance(session, 10);
    const TeaStatus status = session.status();
    EXPECT_TRUE(status.paused);
    EXPECT_EQ(status.last_step, 10);
    EXPECT_NEAR(status.milk_m3, small_glass().milk_m3, 1e-9);
    const auto snapshot = session.snapshot();
    ASSERT_NE(snapshot, nullptr);
    EXPECT_EQ(snapshot->seen.step, 10);
    EXPECT_FALSE(snapshot->seen.parcels.empty());
    const std::vector<float>& shares = snapshot->milk_share.values();
    const double sum = std::accumulate(shares.begin(), shares.end(), 0.0);
    EXPECT_NEAR(sum * snapshot->milk_share.shape().cell_volume_m3(), small_glass().milk_m3,
                1e-5 * small_glass().milk_m3);
    EXPECT_GT(
        *std::max_element(snapshot->to_lamp_m.values().begin(), snapshot->to_lamp_m.values().end()),
        1e-4F);
}

/// As MilkTea pours it by itself: to the last bit.
TEST(TeaSession, TheRecipeIsThatOfTheEngine) {
    TeaSession session(small_glass(), true, [] {});
    session.pour_recipe(true);
    advance(session, 9);
    liquid::MilkTea tea(small_glass());
    core::ThreadPool pool;
    for (int step = 0; step < 9; ++step)
        tea.step(pool);
    const TeaFrame seen = session.snapshot()->seen;
    ASSERT_EQ(seen.parcels.size(), tea.parcels().size());
    for (std::size_t i = 0; i < seen.parcels.size(); ++i)
        EXPECT_EQ(seen.parcels[i].position_m, tea.parcels()[i].position_m);
    EXPECT_EQ(seen.dissolved.values(), tea.dissolved().values());
}

TEST(TeaSession, ClearTeaRestsUntilSomethingIsDoneToIt) {
    TeaSession session(small_glass(), false, [] {});
    session.set_full_speed(true);
    for (int turn = 0; turn < 20; ++turn) {
        session.set_numbers(small_glass());
        session.wait_until_applied();
        EXPECT_EQ(session.status().last_step, 0);
    }
    EXPECT_TRUE(session.status().at_rest);
    EXPECT_FALSE(session.status().paused);
    session.pour(glm::vec2(0.06F, 0.05F));
    wait_for_step(session, 3);
    session.pour(std::nullopt);
    session.wait_until_applied();
    EXPECT_FALSE(session.status().at_rest);
    session.new_glass(small_glass());
    session.wait_until_applied();
    EXPECT_TRUE(session.status().at_rest);
    TeaForce force;
    force.on = true;
    session.set_force(force);
    wait_for_step(session, 3);
    EXPECT_EQ(session.status().milk_m3, 0.0);
}

TEST(TeaSession, TheRecipeIsPouredAsOftenAsOneLikes) {
    TeaSession session(small_glass(), true, [] {});
    for (int times = 1; times <= 2; ++times) {
        session.pour_recipe(true);
        session.wait_until_applied();
        EXPECT_TRUE(session.status().recipe_flows);
        advance(session, 10);
        EXPECT_FALSE(session.status().recipe_flows);
        EXPECT_NEAR(session.status().milk_m3, times * small_glass().milk_m3, 1e-9);
    }
    session.pour_recipe(true);
    session.pour_recipe(false);
    // What has ended does not go on when it would last longer.
    liquid::TeaSettings longer = small_glass();
    longer.pour_s = 2.0;
    session.set_numbers(longer);
    advance(session, 10);
    EXPECT_NEAR(session.status().milk_m3, 2.0 * small_glass().milk_m3, 1e-9);
}

TEST(TeaSession, WhatIsSaidIsSaidOfWhatIsSeen) {
    TeaSession session(small_glass(), false, [] {});
    session.pour_recipe(true);
    session.set_full_speed(true);
    session.wait_until_applied();
    for (int seen = 0; seen < 12;) {
        const TeaSession::Published published = session.published();
        ASSERT_EQ(published.status.step, published.snapshot->seen.step);
        seen = published.status.step;
    }
}

TEST(TeaSession, StandsStillWhilePaused) {
    TeaSession session(small_glass(), true, [] {});
    session.pour_recipe(true);
    // After each of them the session would make a step if it could.
    for (int turn = 0; turn < 20; ++turn) {
        session.set_full_speed(turn % 2 == 0);
        session.wait_until_applied();
        EXPECT_EQ(session.status().last_step, 0);
    }
    session.set_paused(false);
    wait_for_step(session, 1);
}

/// The press and the lift come before a single step is made.
TEST(TeaSession, AClickPoursHoweverShortItIs) {
    liquid::TeaSettings settings = small_glass();
    settings.milk_m3 = 1e-7;
    settings.parcels = 4;
    settings.pour_s = 0.02;
    TeaSession session(settings, true, [] {});
    session.pour_recipe(true);
    advance(session, 2);
    const double before_m3 = session.status().milk_m3;
    session.set_paused(false);
    session.pour(glm::vec2(0.06F, 0.05F));
    session.pour(std::nullopt);
    session.wait_until_applied();
    wait_for_step(session, session.status().last_step + 6);  // it falls
    EXPECT_GT(session.status().milk_m3, before_m3);
    EXPECT_FALSE(session.status().pouring);
}

TEST(TeaSession, TheForceStirsWhileItIsOn) {
    TeaSession session(small_glass(), true, [] {});
    TeaForce force = session.status().force;
    EXPECT_FALSE(force.on);
    force.on = true;
    force.axis_m = {0.04, 0.05};
    session.set_force(force);
    session.wait_until_applied();
    EXPECT_EQ(session.status().force, force);
    EXPECT_EQ(session.snapshot()->settings.swirl_rad_s2, force.swirl_rad_s2);
    EXPECT_EQ(session.snapshot()->settings.swirl_x_m, 0.04);
    force.on = false;
    session.set_force(force);
    session.wait_until_applied();
    EXPECT_EQ(session.snapshot()->settings.swirl_rad_s2, 0.0);
}

TEST(TeaSession, WhatCannotBeIsToldAndChangesNothing) {
    TeaSession session(small_glass(), true, [] {});
    session.wait_until_applied();
    liquid::TeaSettings bad = small_glass();
    bad.viscosity_m2_s = -1.0;
    session.set_numbers(bad);
    session.wait_until_applied();
    std::vector<std::string> errors = core::texts_of(session.take_errors());
    ASSERT_EQ(errors.size(), 1U);
    EXPECT_NE(errors[0].find("viscosity_m2_s is -1"), std::string::npos) << errors[0];
    EXPECT_EQ(session.snapshot()->settings.viscosity_m2_s, small_glass().viscosity_m2_s);
    bad = small_glass();
    bad.cells = 4096;
    session.new_glass(bad);
    session.wait_until_applied();
    EXPECT_EQ(session.take_errors().size(), 1U);
    EXPECT_EQ(session.status().glass, 1);
    EXPECT_FALSE(session.status().busy);
    TeaForce force;
    force.swirl_rad_s2 = std::numeric_limits<double>::quiet_NaN();
    force.on = true;
    session.set_force(force);
    session.wait_until_applied();
    EXPECT_EQ(session.take_errors().size(), 1U);
    EXPECT_FALSE(session.status().force.on);
}

TEST(TeaSession, AnyMomentIsShownAgainAndTheLastGoesOn) {
    TeaSession session(small_glass(), true, [] {});
    session.pour_recipe(true);
    session.advance(20);
    session.show(7);
    session.wait_until_applied();
    TeaStatus status = session.status();
    EXPECT_TRUE(status.paused);
    EXPECT_FALSE(status.shows_last);
    EXPECT_EQ(status.step, 7);
    EXPECT_EQ(session.snapshot()->seen.step, 7);
    const int last = status.last_step;
    session.set_paused(false);
    wait_for_step(session, last + 1);
    EXPECT_TRUE(session.status().shows_last);
}

TEST(TeaSession, SaysWhenTheGlassIsFull) {
    liquid::TeaSettings settings = small_glass();
    settings.pour_s = 0.05;
    TeaSession session(settings, true, [] {});
    session.pour(settings.cup.axis_m);
    advance(session, 2);
    EXPECT_FALSE(session.status().full);
    advance(session, 20);
    EXPECT_TRUE(session.status().full);
    EXPECT_LT(session.snapshot()->cup().level_m, settings.cup.rim_m);
}

TEST(TeaSession, ANewGlassBeginsAtNothing) {
    TeaSession session(small_glass(), true, [] {});
    session.pour_recipe(true);
    session.advance(5);
    session.new_glass(small_glass());
    session.wait_until_applied();
    EXPECT_EQ(session.status().last_step, 0);
    EXPECT_EQ(session.status().milk_m3, 0.0);
    EXPECT_EQ(session.status().glass, 2);
    EXPECT_EQ(session.status().kept, std::vector<int>{0});
}

TEST(TeaFrames, GivesBackWhatItKept) {
    grid::BoxField dissolved(grid::BoxShape{4, 4, 4, 0.01F});
    dissolved.at(1, 2, 3) = 0.25F;
    TeaFrames frames(1 << 20);
    const liquid::ParcelShape shape = {.xx = 4.0F, .xz = 0.5F};
    liquid::SeenPour pour{.level_m = 0.08F, .streams = {{.at_m = {0.04F, 0.05F}, .lip_m = 0.12F}}};
    frames.keep(0, {{.position_m = {0.1F, 0.2F, 0.3F}, .volume_m3 = 2e-9F, .shape = shape}}, dissolved,
                pour);
    frames.keep(1, {}, dissolved, {});
    const TeaFrame first = frames.at(0);
    ASSERT_EQ(first.parcels.size(), 1U);
    EXPECT_EQ(first.parcels[0].position_m, glm::vec3(0.1F, 0.2F, 0.3F));
    EXPECT_EQ(first.parcels[0].volume_m3, 2e-9F);
    EXPECT_EQ(first.parcels[0].shape, shape);
    // Half a step of the sixteen bits.
    EXPECT_NEAR(first.dissolved.at(1, 2, 3), 0.25F, 0.5F / 65535.0F);
    EXPECT_EQ(first.pour, pour);
    EXPECT_EQ(frames.at(9).step, 1);
}

TEST(TeaFrames, KeepsToItsMemoryByKeepingFewer) {
    const grid::BoxField dissolved(grid::BoxShape{8, 8, 8, 0.01F});
    const std::size_t one = 8 * 8 * 8 * sizeof(std::uint16_t);
    TeaFrames frames(10 * one);
    for (int step = 0; step <= 100; ++step)
        frames.keep(step, {}, dissolved, {});
    EXPECT_LE(frames.bytes(), 10 * one);
    const std::vector<int> steps = frames.steps();
    EXPECT_EQ(steps.front(), 0);
    EXPECT_GE(steps.size(), 5U);
    EXPECT_GE(steps.back() + frames.interval(), 100);
    for (const int step : steps)
        EXPECT_EQ(step % frames.interval(), 0);
    EXPECT_EQ(frames.at(50).step, 50 / frames.interval() * frames.interval());
}

TEST(LiquidPicture, IsTracedAndEndsWhenItIsTold) {
    TeaSession session(small_glass(), true, [] {});
    session.wait_until_applied();
    LiquidPictureOrder order;
    order.scene = [snapshot = session.snapshot()](core::ThreadPool& pool, trace::MilkBody body) {
        return traced_tea(*snapshot, {}, body, pool);
    };
    order.width = order.height = 24;
    order.samples = 3;
    std::atomic<int> notes = 0;
    LiquidPicture picture(order, [&] { ++notes; });
    ASSERT_TRUE(tests::comes_true([&] { return picture.progress().finished; }));
    EXPECT_EQ(picture.progress().samples, 3);
    EXPECT_EQ(picture.progress().error.text(), "");
    // The word of the last one comes a moment after it.
    EXPECT_TRUE(tests::comes_true([&] { return notes >= 3; }));
    ASSERT_NE(picture.shown(), nullptr);
    const std::vector<std::uint8_t>& shown = picture.shown()->rgb;
    EXPECT_EQ(shown.size(), 3U * 24U * 24U);
    EXPECT_NE(*std::max_element(shown.begin(), shown.end()),
              *std::min_element(shown.begin(), shown.end()));

    order.samples = 1000000;
    LiquidPicture endless(order, [] {});
    endless.stop();
    EXPECT_TRUE(tests::comes_true([&] { return endless.progress().finished; }));
    EXPECT_LT(endless.progress().samples, 1000000);
}

TEST(LiquidPicture, TellsWhyThereIsNone) {
    TeaSession session(small_glass(), true, [] {});
    session.wait_until_applied();
    LiquidPictureOrder order;
    order.scene = [snapshot = session.snapshot()](core::ThreadPool& pool, trace::MilkBody body) {
        return traced_tea(*snapshot, {}, body, pool);
    };
    order.width = 0;
    LiquidPicture picture(order, [] {});
    ASSERT_TRUE(tests::comes_true([&] { return picture.progress().finished; }));
    EXPECT_NE(picture.progress().error.text(), "");
}

}  // namespace
}  // namespace pastoso::session
