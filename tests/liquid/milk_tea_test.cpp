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
                if (tea_distance_m(tea.settings().cup, shape.cell_m * at) > -shape.cell_m) continue;
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
    settings.pour_s = 0.5;
    MilkTea tea(settings);
    run(tea, 0.5, pool);
    const std::size_t before = tea.parcels().size();
    tea.pour_by_hand(glm::vec2(0.035F, 0.05F));
    tea.step(pool);
    tea.step(pool);
    tea.pour_by_hand(std::nullopt);
    ASSERT_GT(tea.parcels().size(), before);
    double x_m = 0.0;
    for (std::size_t i = before; i < tea.parcels().size(); ++i)
        x_m += static_cast<double>(tea.parcels()[i].position_m.x);
    x_m /= static_cast<double>(tea.parcels().size() - before);
    // The stream is 12 mm wide.
    EXPECT_NEAR(x_m, 0.035, 0.002);
    const std::size_t poured = tea.parcels().size();
    tea.step(pool);
    EXPECT_LE(tea.parcels().size(), poured);
    EXPECT_NEAR(tea.milk_m3(pool), tea.poured_m3(), 1e-5 * tea.poured_m3());
}

TEST(MilkTea, AHandBesideTheCupPoursAlongItsWall) {
    core::ThreadPool pool(2);
    MilkTea tea(small_tea());
    tea.pour_by_hand(glm::vec2(-3.0F, 5.0F));
    run(tea, 0.5, pool);
    for (const Parcel& parcel : tea.parcels())
        EXPECT_LE(tea_distance_m(tea.settings().cup, parcel.position_m), 1e-6F);
}

TEST(MilkTea, TheGlassDoesNotOverflow) {
    core::ThreadPool pool(2);
    TeaSettings settings = small_tea();
    settings.cells = 12;
    settings.pour_s = 0.05;
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
