#include "liquid/tea/milk_tea.hpp"

#include "core/error.hpp"
#include "liquid/flow/sampling.hpp"

#include <cmath>
#include <limits>

#include <gtest/gtest.h>

namespace pastoso::liquid {
namespace {

TeaSettings small_tea() {
    TeaSettings settings;
    settings.cells = 24;
    settings.parcels = 1500;
    return settings;
}

void run(MilkTea& tea, double until_s, core::ThreadPool& pool) {
    while (tea.time_s() < until_s)
        tea.step(pool);
}

void expect_parcels_in_cup(const MilkTea& tea) {
    for (const Parcel& parcel : tea.parcels())
        ASSERT_LE(tea_distance_m(tea.cup(), parcel.position_m), 1e-6F);
}

/// Height of the middle of all milk in parcels.
double middle_mm(const MilkTea& tea) {
    double volume = 0.0, moment = 0.0;
    for (const Parcel& parcel : tea.parcels()) {
        volume += static_cast<double>(parcel.volume_m3);
        moment += static_cast<double>(parcel.volume_m3 * parcel.position_m.z);
    }
    return 1e3 * moment / volume;
}

/// Standard deviation of dissolved milk over its mean, one cell and more from the walls.
double unevenness(const MilkTea& tea) {
    const grid::BoxShape& shape = tea.dissolved().shape();
    double sum = 0.0, squares = 0.0;
    int count = 0;
    for (int k = 0; k < shape.nz; ++k)
        for (int j = 0; j < shape.ny; ++j)
            for (int i = 0; i < shape.nx; ++i) {
                const glm::vec3 at(static_cast<float>(i) + 0.5F, static_cast<float>(j) + 0.5F,
                                   static_cast<float>(k) + 0.5F);
                if (tea_distance_m(tea.cup(), shape.cell_m * at) > -shape.cell_m) continue;
                const auto share = static_cast<double>(tea.dissolved().at(i, j, k));
                sum += share;
                squares += share * share;
                ++count;
            }
    const double mean = sum / count;
    return std::sqrt(std::max(0.0, squares / count - mean * mean)) / mean;
}

TEST(MilkTea, AllMilkOfTheRecipeIsPouredAndKept) {
    core::ThreadPool pool(2);
    TeaSettings settings = small_tea();
    settings.rest_ends_s = settings.dissolving_s = 5.0;
    MilkTea tea(settings);
    run(tea, 2.0, pool);
    EXPECT_EQ(tea.parcels().size(), 1500U);
    EXPECT_NEAR(tea.poured_m3(), settings.milk_m3, 1e-6 * settings.milk_m3);
    run(tea, 40.0, pool);
    EXPECT_LT(tea.parcels().size(), 1500U) << "nothing has dissolved: the test says nothing";
    // Specified is 1e-4; floats that are added to floats some thousand times leave a hundredth of it.
    EXPECT_NEAR(tea.milk_m3(pool), tea.poured_m3(), 1e-5 * tea.poured_m3());
}

TEST(MilkTea, ItSinksBallsFormAndItBecomesEven) {
    core::ThreadPool pool(2);
    TeaSettings settings = small_tea();
    settings.pour_height_m = 0.0;
    settings.first_ball_s = 3.0;
    settings.rest_ends_s = 8.0;
    MilkTea tea(settings);
    run(tea, 0.6, pool);
    const double poured_mm = middle_mm(tea);
    run(tea, 3.0, pool);
    EXPECT_LT(middle_mm(tea), 0.6 * poured_mm);
    EXPECT_EQ(tea.ball_count(), 0);
    run(tea, 6.0, pool);
    const int early = tea.ball_count();
    EXPECT_GT(early, 0);
    run(tea, 12.0, pool);
    EXPECT_GT(tea.ball_count(), 2 * early);
    const double before = unevenness(tea);
    run(tea, 40.0, pool);
    EXPECT_LT(unevenness(tea), 0.5 * before);
}

TEST(MilkTea, TheSameBitsOnAnyNumberOfThreads) {
    const auto after_some_steps = [](int threads) {
        core::ThreadPool pool(threads);
        TeaSettings settings = small_tea();
        settings.first_ball_s = 0.5;
        settings.confinement = 0.1;
        settings.swirl_rad_s2 = 3.0;
        MilkTea tea(settings);
        run(tea, 2.0, pool);
        return std::tuple(tea.parcels(), tea.dissolved(), tea.coldness(), tea.flow().velocity());
    };
    const auto one = after_some_steps(1);
    EXPECT_EQ(one, after_some_steps(2));
    EXPECT_EQ(one, after_some_steps(3));
}

TEST(MilkTea, MilkThatIsPouredByHandFallsWhereTheHandIs) {
    core::ThreadPool pool(2);
    TeaSettings settings = small_tea();
    settings.pour_height_m = 0.018;
    MilkTea tea(settings);
    tea.pour_recipe(false);
    tea.pour_by_hand(glm::vec2(0.035F, 0.05F));
    tea.step(pool);
    tea.pour_by_hand(std::nullopt);
    EXPECT_TRUE(tea.parcels().empty()) << "it is in the air";
    ASSERT_EQ(tea.pour().streams.size(), 1U);
    run(tea, 0.2, pool);
    EXPECT_TRUE(tea.pour().streams.empty());
    // As much as flows in a step.
    EXPECT_NEAR(tea.parcels().size(), 1500.0 / settings.pour_s * settings.step_s, 1.0);
    double x_m = 0.0;
    for (const Parcel& parcel : tea.parcels())
        x_m += static_cast<double>(parcel.position_m.x);
    x_m /= static_cast<double>(tea.parcels().size());
    // The stream is 6 mm wide.
    EXPECT_NEAR(x_m, 0.035, 0.002);
    EXPECT_NEAR(tea.milk_m3(pool), tea.poured_m3(), 1e-5 * tea.poured_m3());
}

TEST(MilkTea, TheLevelRisesByWhatIsPoured) {
    core::ThreadPool pool(2);
    MilkTea tea(small_tea());
    const Cup& cup = tea.settings().cup;
    const double rest_m3 = tea_volume_m3(cup) - tea.settings().milk_m3;
    EXPECT_NEAR(tea_volume_m3(tea.cup()), rest_m3, 1e-6 * rest_m3);
    const long cells_at_rest = tea.flow().walls().open_cell_count();
    long cells = tea.flow().walls().open_cell_count();
    while (tea.time_s() < 2.5) {
        tea.step(pool);
        EXPECT_NEAR(tea_volume_m3(tea.cup()), rest_m3 + tea.poured_m3(), 1e-6 * rest_m3);
        expect_parcels_in_cup(tea);
        EXPECT_GE(tea.flow().walls().open_cell_count(), cells);
        cells = tea.flow().walls().open_cell_count();
    }
    EXPECT_NEAR(tea.cup().level_m, cup.level_m, 1e-6F);
    EXPECT_GT(cells, cells_at_rest);
    EXPECT_NEAR(tea.milk_m3(pool), tea.poured_m3(), 1e-5 * tea.poured_m3());
}

/// Milk poured into a cloudy glass does not come to stand under a clear layer.
TEST(MilkTea, WhatIsCloudyStaysSoUpToARisingLevel) {
    core::ThreadPool pool(2);
    TeaSettings settings = small_tea();
    settings.dissolving_at_rest_s = 0.05;
    MilkTea tea(settings);
    run(tea, 60.0, pool);
    const double before_m3 = tea.milk_m3(pool);
    const float level_m = tea.cup().level_m;
    tea.pour_by_hand(settings.cup.axis_m);
    run(tea, 60.4, pool);
    const grid::BoxShape& shape = tea.flow().shape();
    ASSERT_GT(tea.cup().level_m, level_m + 0.1F * shape.cell_m);
    EXPECT_NEAR(tea.milk_m3(pool) - before_m3, tea.poured_m3() - settings.milk_m3, 1e-5 * before_m3);
    const int top = static_cast<int>((tea.cup().level_m - 1e-5F) / shape.cell_m);
    const float beside = tea.dissolved().at(6, shape.ny / 2, top);
    EXPECT_GT(beside, 0.5F * static_cast<float>(before_m3 / tea_volume_m3(settings.cup)));
}

/// It falls as a stone does, and its stream narrows as its speed grows.
TEST(MilkTea, MilkFallsFreelyThroughTheAir) {
    core::ThreadPool pool(2);
    TeaSettings settings = small_tea();
    settings.pour_height_m = 0.12;
    settings.pour_s = 0.06;
    settings.step_s = 0.01;
    MilkTea tea(settings);
    EXPECT_TRUE(tea.pour().streams.empty());
    const double v0 = settings.pour_speed_m_s, g = 9.81;
    const double fall_s = (std::sqrt(v0 * v0 + 2.0 * g * settings.pour_height_m) - v0) / g;
    while (tea.time_s() < fall_s - settings.step_s) {
        tea.step(pool);
        const double t = tea.time_s(), since = std::max(t - settings.pour_s, 0.0);
        const SeenPour pour = tea.pour();
        ASSERT_EQ(pour.streams.size(), 1U);
        const MilkStream& stream = pour.streams[0];
        const double lip_m = static_cast<double>(pour.level_m) + settings.pour_height_m;
        EXPECT_NEAR(stream.low_m, lip_m - (v0 * t + 0.5 * g * t * t), 1e-6);
        EXPECT_NEAR(stream.high_m, lip_m - (v0 * since + 0.5 * g * since * since), 1e-6);
        const double v = v0 + g * t;
        EXPECT_NEAR(stream.speed_m_s(stream.low_m), v, 1e-4);
        EXPECT_NEAR(stream.radius_m(stream.low_m), settings.pour_radius_m * std::sqrt(v0 / v), 1e-7);
        EXPECT_TRUE(tea.parcels().empty());
    }
    run(tea, 0.3, pool);
    EXPECT_TRUE(tea.pour().streams.empty());
    EXPECT_EQ(tea.parcels().size(), 1500U);
}

TEST(MilkTea, AHandBesideTheCupPoursAlongItsWall) {
    core::ThreadPool pool(2);
    MilkTea tea(small_tea());
    tea.pour_by_hand(glm::vec2(-3.0F, 5.0F));
    run(tea, 0.5, pool);
    expect_parcels_in_cup(tea);
}

TEST(MilkTea, TheGlassDoesNotOverflow) {
    core::ThreadPool pool(2);
    TeaSettings settings = small_tea();
    settings.cells = 12;
    settings.pour_s = 0.05;
    MilkTea tea(settings);
    tea.pour_by_hand(settings.cup.axis_m);
    run(tea, 3.0, pool);
    EXPECT_LT(tea.cup().level_m, settings.cup.rim_m);
    EXPECT_TRUE(tea.is_full());
    EXPECT_TRUE(tea.pour().streams.empty()) << "the hand still pours, but nothing comes";
    // 2 mm are left; a parcel lifts it by 0.003 mm.
    EXPECT_NEAR(tea.cup().level_m, settings.cup.rim_m - 0.002F, 1e-5F);
    expect_parcels_in_cup(tea);
}

/// A glass that the recipe fills to its rim gets all of it.
TEST(MilkTea, TheRecipeFitsABrimfulGlass) {
    core::ThreadPool pool(2);
    TeaSettings settings = small_tea();
    settings.cells = 12;
    settings.cup.rim_m = settings.cup.level_m;
    MilkTea tea(settings);
    run(tea, 2.0, pool);
    EXPECT_EQ(tea.parcels().size(), 1500U);
    EXPECT_TRUE(tea.is_full());
}

TEST(MilkTea, NoMoreIsPouredThanTheTeaIsHalfMilk) {
    core::ThreadPool pool(2);
    TeaSettings settings = small_tea();
    settings.cells = 12;
    settings.pour_s = 0.05;
    settings.cup.level_m = 0.03F;
    settings.milk_m3 = 20e-6;
    MilkTea tea(settings);
    tea.pour_by_hand(settings.cup.axis_m);
    run(tea, 3.0, pool);
    EXPECT_LE(tea.poured_m3(), 0.5 * tea_volume_m3(settings.cup));
    EXPECT_GT(tea.poured_m3(), 0.49 * tea_volume_m3(settings.cup));
}

TEST(MilkTea, TheSwirlTurnsTheTeaAndItsReverseTurnsItBack) {
    core::ThreadPool pool(2);
    const auto turning = [&](double swirl) {
        TeaSettings settings = small_tea();
        settings.milk_m3 = 0.0;
        settings.swirl_rad_s2 = swirl;
        MilkTea tea(settings);
        run(tea, 0.5, pool);
        return velocity_at(tea.flow().velocity(), {0.065F, 0.05F, 0.05F}, Interpolation::Linear).y;
    };
    EXPECT_GT(turning(5.0), 0.01F);
    // The solver's sums are not symmetric to the last bit.
    EXPECT_NEAR(turning(5.0), -turning(-5.0), 1e-3F * turning(5.0));
}

TEST(MilkTea, TheSwirlStandsWhereItsAxisStands) {
    core::ThreadPool pool(2);
    const auto across_the_middle = [&](double axis_x_m) {
        TeaSettings settings = small_tea();
        settings.milk_m3 = 0.0;
        settings.swirl_rad_s2 = 5.0;
        settings.force_reach_m = 0.012;
        settings.swirl_x_m = axis_x_m;
        MilkTea tea(settings);
        run(tea, 0.5, pool);
        return velocity_at(tea.flow().velocity(), {0.05F, 0.05F, 0.05F}, Interpolation::Linear).y;
    };
    EXPECT_GT(across_the_middle(0.038), 0.002F);
    EXPECT_LT(across_the_middle(0.062), -0.002F);
}

TEST(MilkTea, APushGoesDownAlongTheAxisAndComesBackBesideIt) {
    core::ThreadPool pool(2);
    TeaSettings settings = small_tea();
    settings.milk_m3 = 0.0;
    settings.push_m_s2 = 0.2;
    settings.force_reach_m = 0.01;
    MilkTea tea(settings);
    run(tea, 0.5, pool);
    const auto rising = [&](float x_m) {
        return velocity_at(tea.flow().velocity(), {x_m, 0.05F, 0.05F}, Interpolation::Linear).z;
    };
    EXPECT_LT(rising(0.05F), -0.01F);
    EXPECT_GT(rising(0.08F), 0.001F);
}

TEST(MilkTea, NumbersMayChangeWhileItRunsButNotTheGlass) {
    core::ThreadPool pool(1);
    MilkTea tea(small_tea());
    TeaSettings settings = small_tea();
    settings.viscosity_m2_s = 1e-3;
    EXPECT_NO_THROW(tea.set_settings(settings));
    settings.cells = 32;
    EXPECT_THROW(tea.set_settings(settings), core::InputError);
    settings = small_tea();
    settings.cold_m_s2 = std::numeric_limits<double>::quiet_NaN();
    EXPECT_THROW(tea.set_settings(settings), core::InputError);
    EXPECT_EQ(tea.settings().viscosity_m2_s, 1e-3);
}

}  // namespace
}  // namespace pastoso::liquid
