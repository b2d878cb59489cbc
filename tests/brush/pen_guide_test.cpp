#include "brush/pen_guide.hpp"

#include "core/random.hpp"

#include <cmath>

#include <gtest/gtest.h>

namespace pastoso::brush {
namespace {

PenSample at(double x_mm, double y_mm, double rotation_deg = 0.0) {
    return {.time_s = 1.5,
            .x_mm = x_mm,
            .y_mm = y_mm,
            .pressure = 0.3,
            .tilt_x_deg = 4.0,
            .tilt_y_deg = 5.0,
            .rotation_deg = rotation_deg};
}

PenSample led(const PenGuide& guide, const PenSample& down, const PenSample& sample) {
    return guided(guide, down, down, sample);
}

void expect_at(const PenSample& sample, double x_mm, double y_mm) {
    EXPECT_NEAR(sample.x_mm, x_mm, 1e-12);
    EXPECT_NEAR(sample.y_mm, y_mm, 1e-12);
}

/// y = 10 + 3/4 x.
const PenGuide kRuler{.form = Ruler{0.0, 10.0, 4.0, 13.0}, .reach_mm = 2.0};

TEST(PenGuide, NoneAndALineInTheMakingLeaveTheSampleAlone) {
    EXPECT_EQ(led({}, at(1.0, 2.0), at(7.0, 9.0, 40.0)), at(7.0, 9.0, 40.0));
    EXPECT_EQ(led({.form = StraightLine{}}, at(1.0, 2.0), at(7.0, 9.0, 40.0)), at(7.0, 9.0, 40.0));
}

TEST(Ruler, TakesStrokesThatStartNearItToItsEdge) {
    // 5 mm from the foot (8, 16) at right angles.
    expect_at(led(kRuler, at(4.0, 14.9), at(5.0, 20.0)), 8.0, 16.0);
    expect_at(led(kRuler, at(4.0, 11.1), at(11.0, 12.0)), 8.0, 16.0);
}

TEST(Ruler, LetsOthersRunParallel) {
    const PenSample down = at(5.0, 20.0);  // 5 mm beside the ruler
    expect_at(led(kRuler, down, down), 5.0, 20.0);
    expect_at(led(kRuler, down, at(8.0, 16.0)), 5.0, 20.0);
    expect_at(led(kRuler, down, at(16.0, 22.0)), 13.0, 26.0);
}

TEST(Ruler, KeepsTimePressureAndTilt) {
    const PenSample result = led(kRuler, at(4.0, 13.0), at(5.0, 20.0, 33.0));
    PenSample expected = at(5.0, 20.0, 33.0);
    expected.x_mm = result.x_mm;
    expected.y_mm = result.y_mm;
    EXPECT_EQ(result, expected);
}

TEST(Ruler, IsFollowedOnlyOnce) {
    for (std::uint32_t i = 0; i < 100; ++i) {
        const auto noise = [&](std::uint32_t k) { return 100.0 * core::uniform_noise(i, k); };
        const PenSample down = at(noise(1), noise(2));
        const PenSample once = led(kRuler, down, at(noise(3), noise(4)));
        const PenSample twice = led(kRuler, down, once);
        EXPECT_NEAR(twice.x_mm, once.x_mm, 1e-11);
        EXPECT_NEAR(twice.y_mm, once.y_mm, 1e-11);
    }
}

/// 30 mm wide and 10 mm high, standing upright: the width points down the canvas.
const PenGuide kEllipse{.form = EllipseCurve{50.0, 40.0, 30.0, 10.0, 90.0}, .reach_mm = 2.0};

TEST(EllipseCurve, TakesStrokesThatStartNearItToItsLine) {
    const PenSample down = at(50.0, 71.5);
    expect_at(led(kEllipse, down, down), 50.0, 70.0);
    expect_at(led(kEllipse, down, at(90.0, 40.0)), 60.0, 40.0);
    expect_at(led(kEllipse, down, at(50.0, 39.0)), 50.0, 10.0);
    // Half way round in units of the half axes.
    const double root = std::sqrt(0.5);
    expect_at(led(kEllipse, down, at(50.0 + 1.0, 40.0 + 3.0)), 50.0 + 10.0 * root, 40.0 + 30.0 * root);
}

TEST(EllipseCurve, LetsOthersRunOnASimilarOne) {
    const PenSample down = at(50.0, 100.0);
    expect_at(led(kEllipse, down, down), 50.0, 100.0);
    expect_at(led(kEllipse, down, at(51.0, 40.0)), 70.0, 40.0);
}

TEST(EllipseCurve, KeepsItsPlaceWhereThePenCrossesTheCentre) {
    const PenSample down = at(50.0, 70.0);
    const PenSample before = at(60.0, 40.0);
    expect_at(guided(kEllipse, down, before, at(50.0, 40.0)), 60.0, 40.0);
    const PenSample centre = at(50.0, 40.0);
    EXPECT_TRUE(std::isfinite(guided(kEllipse, centre, centre, centre).x_mm));
}

TEST(PenGuide, TurnsTheBrushAcrossTheShorterWay) {
    PenGuide across = kRuler;
    across.turn_across = true;
    const double angle_deg = std::atan2(3.0, 4.0) * 180.0 / 3.14159265358979323846;
    EXPECT_NEAR(led(across, at(4.0, 13.0, 0.0), at(5.0, 13.0, 77.0)).rotation_deg, angle_deg - 90.0,
                1e-12);
    EXPECT_NEAR(led(across, at(4.0, 13.0, 350.0), at(5.0, 13.0)).rotation_deg, angle_deg + 270.0, 1e-12);
    EXPECT_NEAR(led(across, at(4.0, 13.0, 150.0), at(5.0, 13.0)).rotation_deg, angle_deg + 90.0, 1e-12);
}

TEST(PenGuide, TurnsOnAroundACircleWithoutAJump) {
    const PenGuide circle{.form = EllipseCurve{0.0, 0.0, 20.0, 20.0, 0.0}, .turn_across = true};
    const PenSample down = at(20.0, 0.0, 10.0);
    PenSample before = guided(circle, down, down, down);
    EXPECT_NEAR(before.rotation_deg, 0.0, 1e-12);
    for (int i = 1; i <= 720; ++i) {
        const double angle = 3.14159265358979323846 / 180.0 * i;
        before = guided(circle, down, before, at(25.0 * std::cos(angle), 25.0 * std::sin(angle)));
        ASSERT_NEAR(before.rotation_deg, i, 1e-9);
    }
}

TEST(OnSegment, ProjectsAndStopsAtTheEnds) {
    const PenSample from = at(10.0, 10.0), to = at(20.0, 10.0);
    expect_at(on_segment(at(13.0, 77.0), from, to), 13.0, 10.0);
    expect_at(on_segment(at(3.0, 7.0), from, to), 10.0, 10.0);
    expect_at(on_segment(at(33.0, 7.0), from, to), 20.0, 10.0);
    EXPECT_EQ(on_segment(at(13.0, 10.0, 5.0), from, to), at(13.0, 10.0, 5.0));
    expect_at(on_segment(at(33.0, 7.0), from, from), 10.0, 10.0);
}

TEST(Straightened, KeepsPressureAndNeverRunsBack) {
    std::vector<PenSample> samples = {at(0.0, 0.0), at(4.0, 3.0), at(2.0, -8.0), at(14.0, 1.0),
                                      at(10.0, 0.0)};
    samples[1].pressure = 0.9;
    const std::vector<PenSample> line = straightened(samples, false);
    ASSERT_EQ(line.size(), samples.size());
    const double expected_mm[] = {0.0, 4.0, 4.0, 10.0, 10.0};
    for (std::size_t i = 0; i < line.size(); ++i)
        expect_at(line[i], expected_mm[i], 0.0);
    EXPECT_EQ(line[1].pressure, 0.9);
}

TEST(Straightened, TurnsAcrossAndLeavesATapAlone) {
    const std::vector<PenSample> line = straightened({at(0.0, 0.0, 80.0), at(0.0, 9.0, 15.0)}, true);
    EXPECT_DOUBLE_EQ(line[0].rotation_deg, 0.0);
    EXPECT_DOUBLE_EQ(line[1].rotation_deg, 0.0);
    const std::vector<PenSample> tap = {at(3.0, 4.0, 80.0), at(3.0, 4.0, 80.0)};
    EXPECT_EQ(straightened(tap, true), tap);
}

}  // namespace
}  // namespace pastoso::brush
