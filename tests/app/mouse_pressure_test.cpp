// A mouse that presses by its speed.
#include "tools/mouse_pressure.hpp"

#include <cmath>
#include <vector>

#include <gtest/gtest.h>

namespace pastoso::tools {
namespace {

constexpr MouseSettings kBySpeed{.pressure = 0.6, .by_speed = true};

/// A hand that starts, swings along a bow at up to 2500 pixels a second, and slows down.
glm::dvec2 hand_px(double time_s) {
    const double way = 900.0 * (time_s - std::sin(4.0 * time_s) / 5.0);
    return {400.0 * std::sin(way / 400.0), 400.0 - 400.0 * std::cos(way / 400.0)};
}

/// Pressures at every 8 ms of the movement, told at so many events a second.
std::vector<double> pressures(int events_per_s) {
    MousePressure mouse;
    std::vector<double> result;
    const int step_ms = 1000 / events_per_s;
    for (int time_ms = 0; time_ms <= 1600; time_ms += step_ms) {
        mouse.moved_to(hand_px(0.001 * time_ms), static_cast<std::uint64_t>(time_ms + 5000));
        if (time_ms % 8 == 0) result.push_back(mouse.pressure(kBySpeed));
    }
    return result;
}

/// The filter sees mean speeds between events. The error of a mean grows with the square of the
/// interval: over 8 ms of this movement, whose speed changes by up to 14000 px/s2, about 1 px/s, which
/// is below 0.001 of pressure.
TEST(MousePressure, IsTheSameAtEveryRateOfEvents) {
    const std::vector<double> slow = pressures(125), fast = pressures(1000), middle = pressures(250);
    ASSERT_EQ(slow.size(), fast.size());
    double least = 1.0, most = 0.0;
    for (std::size_t i = 0; i < slow.size(); ++i) {
        EXPECT_NEAR(slow[i], fast[i], 0.001) << i;
        EXPECT_NEAR(middle[i], fast[i], 0.001) << i;
        least = std::min(least, fast[i]);
        most = std::max(most, fast[i]);
    }
    EXPECT_GT(most - least, 0.2);  // the movement says something
}

TEST(MousePressure, FasterIsLighterDownToAQuarter) {
    double before = 1.0;
    for (const double speed_px_s : {0.0, 100.0, 500.0, 2000.0, 10000.0}) {
        MousePressure mouse;
        for (int i = 0; i <= 100; ++i)
            mouse.moved_to({0.01 * speed_px_s * i, 0.0}, static_cast<std::uint64_t>(10 * i));
        const double pressure = mouse.pressure(kBySpeed);
        EXPECT_LT(pressure, before);
        EXPECT_NEAR(mouse.speed_px_s(), speed_px_s, 1e-6 + 1e-6 * speed_px_s);
        before = pressure;
    }
    EXPECT_GT(before, 0.25 * kBySpeed.pressure);
    EXPECT_EQ(MousePressure().pressure(kBySpeed), kBySpeed.pressure);
}

TEST(MousePressure, IsAlwaysAlikeUnlessThePainterWantsIt) {
    MousePressure mouse;
    mouse.moved_to({0, 0}, 0);
    mouse.moved_to({500, 0}, 10);
    EXPECT_EQ(mouse.pressure(MouseSettings{}), 0.5);
    EXPECT_EQ(mouse.pressure({.pressure = 0.8}), 0.8);
}

TEST(MousePressure, ForgetsItsSpeedInARest) {
    MousePressure mouse;
    mouse.moved_to({0, 0}, 0);
    mouse.moved_to({500, 0}, 100);
    EXPECT_GT(mouse.speed_px_s(), 3000.0);
    mouse.moved_to({500, 0}, 1100);
    EXPECT_LT(mouse.speed_px_s(), 0.01);
}

TEST(MousePressure, StandsClocksThatStandOrRunBack) {
    MousePressure mouse;
    mouse.moved_to({0, 0}, 100);
    mouse.moved_to({4, 0}, 100);
    mouse.moved_to({8, 0}, 100);
    EXPECT_EQ(mouse.speed_px_s(), 0.0);
    mouse.moved_to({10, 0}, 110);  // 10 pixels in 10 ms
    EXPECT_NEAR(mouse.speed_px_s(), 1000.0 * (1.0 - std::exp(-10.0 / 60.0)), 1e-9);
    mouse.moved_to({900, 0}, 20);
    EXPECT_EQ(mouse.speed_px_s(), 0.0);
}

}  // namespace
}  // namespace pastoso::tools
