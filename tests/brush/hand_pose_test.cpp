#include "brush/hand_pose.hpp"

#include "brush/studio.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include <gtest/gtest.h>

namespace pastoso::brush {
namespace {

const DynamicsCurve kCurve = {
    DynamicsInput::Pressure, DynamicsTarget::Press, {{0.0, 0.0}, {0.3, 0.22}, {1.0, 1.0}}};

PathStep step_with(const PenSample& pen, double speed_mm_s = 0.0) {
    return {pen, 1.0, 0.0, speed_mm_s};
}

TEST(DynamicsCurve, IsLinearBetweenPointsAndConstantBeyond) {
    EXPECT_DOUBLE_EQ(evaluate(kCurve, -1.0), 0.0);
    EXPECT_DOUBLE_EQ(evaluate(kCurve, 0.15), 0.11);
    EXPECT_DOUBLE_EQ(evaluate(kCurve, 0.3), 0.22);
    EXPECT_DOUBLE_EQ(evaluate(kCurve, 0.65), 0.61);
    EXPECT_DOUBLE_EQ(evaluate(kCurve, 2.0), 1.0);
}

TEST(HandPose, WithoutCurvesFollowsThePen) {
    const HandPose pose =
        hand_pose({}, step_with({.pressure = 0.37, .tilt_x_deg = 45.0, .rotation_deg = 90.0}, 1000.0));
    EXPECT_DOUBLE_EQ(pose.press, 0.37);
    EXPECT_NEAR(pose.lean_x, 1.0, 1e-12);
    EXPECT_NEAR(pose.lean_y, 0.0, 1e-12);
    EXPECT_NEAR(pose.sin_rotation, 1.0, 1e-12);
    EXPECT_DOUBLE_EQ(pose.reach, 1.0);
}

TEST(HandPose, AppliesThePresetsCurves) {
    const std::vector<DynamicsCurve>& curves = find_preset("flat").dynamics;
    const HandPose pose = hand_pose(
        curves, step_with({.pressure = 0.15, .tilt_x_deg = -60.0, .rotation_deg = 390.0}, 200.0));
    EXPECT_DOUBLE_EQ(pose.press, 0.11);
    EXPECT_NEAR(pose.lean_x, -1.0, 1e-12);
    EXPECT_NEAR(pose.cos_rotation, std::cos(std::acos(-1.0) / 6.0), 1e-12);
    EXPECT_NEAR(pose.reach, 0.8, 1e-12);
}

TEST(HandPose, MultipliesCurvesOfOneTarget) {
    const DynamicsCurve by_speed = {
        DynamicsInput::Speed, DynamicsTarget::Press, {{0.0, 1.0}, {100.0, 0.5}}};
    const HandPose pose = hand_pose({kCurve, by_speed}, step_with({.pressure = 1.0}, 50.0));
    EXPECT_DOUBLE_EQ(pose.press, 0.75);
}

TEST(CurveInputs, AreWhatTheStrokeTells) {
    PathStep step = step_with({.time_s = 3.5, .wheel = -0.5}, 40.0);
    step.travelled_mm = 30.0;
    const StrokeState stroke{.begun_s = 1.5, .width_mm = 12.0, .seed = 7, .fill = 0.4};
    const auto read = [&](DynamicsInput input) { return input_value(input, step, stroke); };
    EXPECT_DOUBLE_EQ(read(DynamicsInput::Speed), 40.0);
    EXPECT_DOUBLE_EQ(read(DynamicsInput::Distance), 30.0);
    EXPECT_DOUBLE_EQ(read(DynamicsInput::Fade), 2.5);
    EXPECT_DOUBLE_EQ(read(DynamicsInput::Time), 2.0);
    EXPECT_DOUBLE_EQ(read(DynamicsInput::Wheel), 0.25);
    EXPECT_DOUBLE_EQ(read(DynamicsInput::Load), 0.4);
}

TEST(CurveInputs, TheDirectionGoesClockwiseFromTheRight) {
    const auto direction = [](double x, double y) {
        return input_value(DynamicsInput::Direction, {{}, x, y}, {});
    };
    EXPECT_DOUBLE_EQ(direction(1.0, 0.0), 0.0);
    EXPECT_DOUBLE_EQ(direction(0.0, 1.0), 90.0);
    EXPECT_DOUBLE_EQ(direction(-1.0, 0.0), 180.0);
    EXPECT_DOUBLE_EQ(direction(0.0, -1.0), 270.0);
}

TEST(CurveInputs, ChanceComesFromTheStrokesSeed) {
    PathStep step = step_with({});
    double sum = 0.0;
    for (std::uint32_t seed = 0; seed < 100; ++seed) {
        const double value = input_value(DynamicsInput::StrokeRandom, step, {.seed = seed});
        EXPECT_EQ(value, input_value(DynamicsInput::StrokeRandom, step, {.seed = seed}));
        EXPECT_GE(value, 0.0);
        EXPECT_LT(value, 1.0);
        sum += value;
    }
    EXPECT_NEAR(sum / 100.0, 0.5, 0.1);  // 0.029 times three and a half
    const StrokeState stroke{.width_mm = 10.0, .seed = 5};
    const auto along = [&](double travelled_mm) {
        step.travelled_mm = travelled_mm;
        return input_value(DynamicsInput::DabRandom, step, stroke);
    };
    double least = 1.0, most = 0.0;
    for (double mm = 0.0; mm < 500.0; mm += 0.5) {
        least = std::min(least, along(mm));
        most = std::max(most, along(mm));
        EXPECT_LT(std::abs(along(mm + 0.5) - along(mm)), 0.16) << "smoothly: at most 3/2 in 5 mm";
    }
    EXPECT_GE(least, 0.0);
    EXPECT_LT(least, 0.1);
    EXPECT_GT(most, 0.9);
    EXPECT_LE(most, 1.0);
}

/// What each of some strokes of one brush leaves on a canvas of its own.
std::vector<film::FilmState> strokes_of(const Preset& preset, int count) {
    Brush brush(preset, 0.0, 3);
    std::vector<film::FilmState> films;
    for (int i = 0; i < count; ++i) {
        films.push_back(studio::smooth(60.0, 30.0, 4.0));
        brush.load(studio::dark_paint(), 1.0);
        studio::paint(brush, films.back(), studio::line(10.0, 15.0, 50.0, 15.0, 0.5, 90.0));
    }
    return films;
}

TEST(CurveInputs, ChanceIsAnotherInTheNextStrokeAndTheSameWhenItIsReplayed) {
    Preset preset = studio::flat_preset(12.0, 60);
    preset.dynamics = {{DynamicsInput::StrokeRandom, DynamicsTarget::Film, {{0.0, 0.1}, {1.0, 2.0}}},
                       {DynamicsInput::DabRandom, DynamicsTarget::Reach, {{0.0, 0.5}, {1.0, 2.0}}}};
    const auto once = strokes_of(preset, 2), again = strokes_of(preset, 2);
    for (std::size_t i = 0; i < once.size(); ++i)
        EXPECT_EQ(film::state_hash(once[i]), film::state_hash(again[i]));
    const double first_mm3 = studio::volume_mm3(once[0]), second_mm3 = studio::volume_mm3(once[1]);
    EXPECT_GT(std::abs(first_mm3 - second_mm3), 0.1 * first_mm3);
}

TEST(CurveInputs, TheLoadFallsAlongAStroke) {
    Preset preset = studio::flat_preset(12.0, 60);
    const double as_it_is_mm3 = studio::volume_mm3(strokes_of(preset, 1).front());
    preset.dynamics.push_back({DynamicsInput::Load, DynamicsTarget::Film, {{0.0, 0.0}, {1.0, 1.0}}});
    const double by_load_mm3 = studio::volume_mm3(strokes_of(preset, 1).front());
    EXPECT_LT(by_load_mm3, 0.95 * as_it_is_mm3);
    EXPECT_GT(by_load_mm3, 0.3 * as_it_is_mm3);
}

TEST(HandPose, MirroredTiltLeansTheOtherWay) {
    const auto& curves = find_preset("round").dynamics;
    const HandPose a = hand_pose(curves, step_with({.tilt_x_deg = 20.0, .tilt_y_deg = 30.0}));
    const HandPose b = hand_pose(curves, step_with({.tilt_x_deg = -20.0, .tilt_y_deg = 30.0}));
    EXPECT_DOUBLE_EQ(a.lean_x, -b.lean_x);
    EXPECT_DOUBLE_EQ(a.lean_y, b.lean_y);
    EXPECT_GT(a.lean_y, a.lean_x);
}

}  // namespace
}  // namespace pastoso::brush
