#include "input/pen_forecast.hpp"

#include <cmath>

#include <gtest/gtest.h>

namespace pastoso::input {
namespace {

brush::PenSample at(double time_s, double x_mm, double y_mm, double pressure = 0.5) {
    return {.time_s = time_s, .x_mm = x_mm, .y_mm = y_mm, .pressure = pressure};
}

TEST(PenForecast, APenThatTouchesDownIsExpectedThere) {
    PenForecast forecast;
    forecast.start(at(3.0, 10.0, 20.0, 0.7));
    EXPECT_EQ(forecast.after(0.02), at(3.02, 10.0, 20.0, 0.7));
}

// Whatever the filter's gains are, nothing surprises it.
TEST(PenForecast, ASteadyHandIsForetoldExactly) {
    PenForecast forecast;
    forecast.start(at(0.0, 5.0, 8.0));
    for (const double time_s : {0.004, 0.005, 0.013, 0.021, 0.022, 0.04})
        forecast.add(at(time_s, 5.0 + 120.0 * time_s, 8.0 - 50.0 * time_s));
    const brush::PenSample there = forecast.after(0.016);
    // The first velocity, of which nothing is known, is off by a millionth.
    EXPECT_NEAR(there.x_mm, 5.0 + 120.0 * 0.056, 1e-3);
    EXPECT_NEAR(there.y_mm, 8.0 - 50.0 * 0.056, 1e-3);
}

TEST(PenForecast, ItHoldsThePenAsItWasHeldLast) {
    PenForecast forecast;
    forecast.start(at(0.0, 0.0, 0.0, 0.2));
    brush::PenSample last = at(0.01, 1.0, 0.0, 0.9);
    last.tilt_x_deg = 30.0;
    last.rotation_deg = 70.0;
    forecast.add(last);
    const brush::PenSample there = forecast.after(0.01);
    EXPECT_EQ(there.pressure, 0.9);
    EXPECT_EQ(there.tilt_x_deg, 30.0);
    EXPECT_EQ(there.rotation_deg, 70.0);
}

// In 16 ms the hand goes 1.6 mm; what it turns by is v^2 / r t^2 / 2 = 0.06 mm, and the filter's memory
// of some 5 events adds to that.
TEST(PenForecast, ATurningHandIsForetoldNearly) {
    const auto place = [](double time_s) {
        const double angle = 5.0 * time_s;
        return at(time_s, 20.0 * std::cos(angle), 20.0 * std::sin(angle));
    };
    PenForecast forecast;
    forecast.start(place(0.0));
    for (int i = 1; i <= 100; ++i) {
        forecast.add(place(0.005 * i));
        if (i < 20) continue;
        const brush::PenSample there = forecast.after(0.016), truth = place(0.005 * i + 0.016);
        EXPECT_LT(std::hypot(there.x_mm - truth.x_mm, there.y_mm - truth.y_mm), 0.4);
    }
}

TEST(PenForecast, AHandThatStoppedIsExpectedWhereItIs) {
    PenForecast forecast;
    forecast.start(at(0.0, 0.0, 0.0));
    for (int i = 1; i <= 10; ++i)
        forecast.add(at(0.005 * i, i, 0.0));
    for (int i = 11; i <= 60; ++i)
        forecast.add(at(0.005 * i, 10.0, 0.0));
    EXPECT_NEAR(forecast.after(0.024).x_mm, 10.0, 1e-6);
}

TEST(PenForecast, AClockThatStandsStillIsNoHandOfInfiniteSpeed) {
    PenForecast forecast;
    forecast.start(at(1.0, 0.0, 0.0));
    forecast.add(at(1.0, 3.0, 0.0));
    forecast.add(at(0.5, 4.0, 0.0));
    EXPECT_EQ(forecast.after(0.01).x_mm, 4.0);
}

TEST(PenForecast, ItDoesNotCountHowNearTheCanvasIs) {
    PenForecast near, far;
    near.start(at(0.0, 1.0, 2.0));
    far.start(at(0.0, 16.0, 32.0));
    for (int i = 1; i <= 20; ++i) {
        const double t = 0.008 * i, x = 1.0 + std::sin(9.0 * t), y = 2.0 + t * t;
        near.add(at(t, x, y));
        far.add(at(t, 16.0 * x, 16.0 * y));
    }
    EXPECT_EQ(16.0 * near.after(0.016).x_mm, far.after(0.016).x_mm);
    EXPECT_EQ(16.0 * near.after(0.016).y_mm, far.after(0.016).y_mm);
}

}  // namespace
}  // namespace pastoso::input
