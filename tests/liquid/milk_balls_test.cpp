#include "liquid/tea/milk_balls.hpp"

#include <numbers>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

namespace pastoso::liquid {
namespace {

/// A column of parcels, a millimetre apart.
std::vector<Parcel> column() {
    std::vector<Parcel> parcels;
    for (int i = 0; i < 30; ++i)
        parcels.push_back({{0.05F, 0.05F, 0.005F + 0.001F * static_cast<float>(i)}, 1e-9F, 1.0F, -1});
    return parcels;
}

TEST(MilkBalls, ABallFormsAtTheTopWhenItIsTime) {
    TeaSettings settings;
    settings.ball_candidates = 10000;  // the highest of all
    settings.ball_radius_spread = 0.0;
    std::vector<Parcel> parcels = column();
    MilkBalls balls(settings);
    balls.nucleate(settings.first_ball_s, settings, parcels);
    EXPECT_EQ(balls.count(), 0);
    balls.nucleate(settings.first_ball_s + 0.01, settings, parcels);
    ASSERT_EQ(balls.count(), 1);
    // 6.6 mm around the highest hold it and six below.
    for (int i = 0; i < 30; ++i)
        EXPECT_EQ(parcels[static_cast<std::size_t>(i)].ball, i >= 23 ? 0 : -1) << i;
}

TEST(MilkBalls, BallsComeAsOftenAsTheSettingsSay) {
    TeaSettings settings;
    settings.first_ball_s = 0.0;
    settings.ball_interval_s = 0.5;
    settings.ball_radius_m = 1e-4;
    std::vector<Parcel> parcels(4000, {{0.05F, 0.05F, 0.05F}, 1e-9F, 1.0F, -1});
    for (std::size_t i = 0; i < parcels.size(); ++i)
        parcels[i].position_m.x += 1e-3F * static_cast<float>(i);
    MilkBalls balls(settings);
    for (int tick = 1; tick <= 30 * 400; ++tick)
        balls.nucleate(tick / 30.0, settings, parcels);
    // 800 are expected; the standard deviation of the intervals' sum is 0.6 * sqrt(800) = 17 of them.
    EXPECT_NEAR(balls.count(), 800, 60);
}

TEST(MilkBalls, AnotherSeedMakesOtherBalls) {
    const auto balls_of = [](std::uint32_t seed) {
        TeaSettings settings;
        settings.seed = seed;
        settings.first_ball_s = 0.0;
        std::vector<Parcel> parcels(500, {{0.05F, 0.05F, 0.05F}, 1e-9F, 1.0F, -1});
        for (std::size_t i = 0; i < parcels.size(); ++i)
            parcels[i].position_m.x += 1e-3F * static_cast<float>(i);
        MilkBalls balls(settings);
        for (int tick = 1; tick <= 30 * 4; ++tick)
            balls.nucleate(tick / 30.0, settings, parcels);
        std::vector<int> ball_of;
        for (const Parcel& parcel : parcels)
            ball_of.push_back(parcel.ball);
        return ball_of;
    };
    EXPECT_EQ(balls_of(8), balls_of(8));
    EXPECT_NE(balls_of(8), balls_of(TeaSettings{}.seed));
    EXPECT_NE(balls_of(8), balls_of(9));
}

}  // namespace
}  // namespace pastoso::liquid
