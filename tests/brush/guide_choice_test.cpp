#include "brush/guide_choice.hpp"

#include "core/random.hpp"
#include "core/units.hpp"

#include <cmath>

#include <gtest/gtest.h>

namespace pastoso::brush {
namespace {

PenSample at(double x_mm, double y_mm) {
    return {.x_mm = x_mm, .y_mm = y_mm, .pressure = 0.3, .rotation_deg = 12.0};
}

/// A stroke as it is followed under a guide.
std::vector<PenSample> followed(const PenGuide& guide, const std::vector<PenSample>& hand) {
    GuideChoice choice(guide);
    std::vector<PenSample> passed;
    for (const PenSample& sample : hand) {
        const auto now = choice.add(sample);
        passed.insert(passed.end(), now.begin(), now.end());
    }
    const auto rest = choice.end();
    passed.insert(passed.end(), rest.begin(), rest.end());
    std::vector<PenSample> led;
    for (const PenSample& sample : passed)
        led.push_back(guided(choice.guide(), passed.front(), led.empty() ? sample : led.back(), sample));
    return led;
}

/// From a place in a direction, trembling, 40 mm far.
std::vector<PenSample> hand_from(double x_mm, double y_mm, double direction_deg) {
    const double angle = core::radians(direction_deg);
    std::vector<PenSample> hand;
    for (int i = 0; i <= 40; ++i) {
        const double beside_mm = i > 5 ? 3.0 * std::sin(0.9 * i) : 0.0;
        hand.push_back(at(x_mm + i * std::cos(angle) - beside_mm * std::sin(angle),
                          y_mm + i * std::sin(angle) + beside_mm * std::cos(angle)));
    }
    return hand;
}

/// How far a place is from the line through two others.
double off_mm(const PenSample& place, double x1, double y1, double x2, double y2) {
    const double length = std::hypot(x2 - x1, y2 - y1);
    return ((place.y_mm - y1) * (x2 - x1) - (place.x_mm - x1) * (y2 - y1)) / length;
}

void expect_on_line(const std::vector<PenSample>& stroke, double x1, double y1, double x2, double y2) {
    ASSERT_GT(stroke.size(), 10U);
    EXPECT_GT(
        std::hypot(stroke.back().x_mm - stroke.front().x_mm, stroke.back().y_mm - stroke.front().y_mm),
        20.0);
    for (const PenSample& place : stroke)
        EXPECT_NEAR(off_mm(place, x1, y1, x2, y2), 0.0, 1e-9);
}

/// On the left and right of the canvas, and far below it.
PenGuide perspective(int count) {
    return {.form = VanishingPoints{.count = count,
                                    .x1_mm = -100.0,
                                    .y1_mm = 40.0,
                                    .x2_mm = 300.0,
                                    .y2_mm = 40.0,
                                    .x3_mm = 90.0,
                                    .y3_mm = 900.0}};
}

PenGuide mixed(PenGuide guide, double strength) {
    guide.strength = strength;
    return guide;
}

TEST(GuideChoice, OthersPassAtOnce) {
    for (const PenGuide& guide : {PenGuide{}, PenGuide{.form = Ruler{}}, mixed(perspective(3), 0.0)}) {
        GuideChoice choice(guide);
        EXPECT_EQ(choice.add(at(1.0, 2.0)), std::vector{at(1.0, 2.0)});
        EXPECT_EQ(choice.add(at(1.5, 2.0)), std::vector{at(1.5, 2.0)});
        EXPECT_TRUE(choice.end().empty());
        EXPECT_EQ(choice.guide(), guide);
    }
}

TEST(GuideChoice, HoldsTheFirstWayBackAndKeepsItsChoice) {
    GuideChoice choice(perspective(1));
    EXPECT_TRUE(choice.add(at(50.0, 40.0)).empty());
    EXPECT_TRUE(choice.add(at(51.0, 43.8)).empty());
    EXPECT_EQ(choice.add(at(50.0, 44.0)), (std::vector{at(50.0, 40.0), at(51.0, 43.8), at(50.0, 44.0)}));
    const PenGuide chosen = choice.guide();
    EXPECT_EQ(choice.add(at(90.0, 42.0)), std::vector{at(90.0, 42.0)});
    EXPECT_EQ(choice.guide(), chosen);
    const PenSample led = guided(chosen, at(50.0, 40.0), at(50.0, 40.0), at(90.0, 42.0));
    EXPECT_NEAR(led.x_mm, 50.0, 1e-9) << "upright, though the hand went on to the right";
    EXPECT_NEAR(led.y_mm, 42.0, 1e-9);
}

/// The line to the other point, backwards, is 16 degrees off.
TEST(GuideChoice, ATremblingStartIsNoDirection) {
    const PenGuide guide{.form = VanishingPoints{
                             .count = 2, .x1_mm = -60.0, .y1_mm = 60.0, .x2_mm = 220.0, .y2_mm = 60.0}};
    const auto stroke =
        followed(guide, {at(80.0, 40.0), at(79.0, 40.0), at(78.0, 39.9), at(76.0, 40.5)});
    EXPECT_NEAR(off_mm(stroke.back(), 80.0, 40.0, -60.0, 60.0), 0.0, 1e-9);
}

TEST(GuideChoice, AStraightLineIsHeldBackToItsEnd) {
    GuideChoice choice({.form = StraightLine{}});
    EXPECT_TRUE(choice.add(at(0.0, 0.0)).empty());
    EXPECT_TRUE(choice.add(at(50.0, 9.0)).empty());
    EXPECT_TRUE(choice.add(at(80.0, 0.0)).empty());
    EXPECT_EQ(choice.end(), straightened({at(0.0, 0.0), at(50.0, 9.0), at(80.0, 0.0)}, false));
}

TEST(GuideChoice, AShortStrokeGoesWhereTheHandHasGone) {
    GuideChoice choice(perspective(1));
    choice.add(at(50.0, 40.0));
    choice.add(at(50.1, 41.0));
    EXPECT_EQ(choice.end().size(), 2U);
    EXPECT_NEAR(guided(choice.guide(), at(50.0, 40.0), at(50.0, 40.0), at(50.1, 41.0)).x_mm, 50.0, 1e-9);
    GuideChoice tap(perspective(1));
    tap.add(at(50.0, 40.0));
    EXPECT_EQ(tap.end(), std::vector{at(50.0, 40.0)});
    EXPECT_EQ(guided(tap.guide(), at(50.0, 40.0), at(50.0, 40.0), at(50.0, 40.0)), at(50.0, 40.0));
}

TEST(Perspective, StrokesRunToThePointThatTheyStartTowards) {
    expect_on_line(followed(perspective(3), hand_from(50.0, 90.0, 200.0)), 50.0, 90.0, -100.0, 40.0);
    expect_on_line(followed(perspective(3), hand_from(50.0, 90.0, -20.0)), 50.0, 90.0, 300.0, 40.0);
    expect_on_line(followed(perspective(3), hand_from(50.0, 90.0, 80.0)), 50.0, 90.0, 90.0, 900.0);
    expect_on_line(followed(perspective(3), hand_from(50.0, 90.0, 20.0)), 50.0, 90.0, -100.0, 40.0);
}

TEST(Perspective, FewerPointsLeaveTheOtherDirections) {
    expect_on_line(followed(perspective(2), hand_from(50.0, 90.0, 80.0)), 50.0, 90.0, 50.0, 0.0);
    expect_on_line(followed(perspective(2), hand_from(50.0, 90.0, 165.0)), 50.0, 90.0, 300.0, 40.0);
    expect_on_line(followed(perspective(1), hand_from(50.0, 90.0, 175.0)), 50.0, 90.0, 0.0, 90.0);
    expect_on_line(followed(perspective(1), hand_from(50.0, 90.0, 20.0)), 50.0, 90.0, -100.0, 40.0);
    PenGuide turned = perspective(2);
    std::get<VanishingPoints>(turned.form).upright_deg = 75.0;
    const double way_x = std::cos(core::radians(75.0)), way_y = std::sin(core::radians(75.0));
    expect_on_line(followed(turned, hand_from(50.0, 90.0, 90.0)), 50.0, 90.0, 50.0 + way_x,
                   90.0 + way_y);
}

TEST(Perspective, OnAVanishingPointTheOtherDirectionsAreLeft) {
    expect_on_line(followed(perspective(1), hand_from(-100.0, 40.0, 20.0)), -100.0, 40.0, 0.0, 40.0);
    PenGuide one_place = perspective(3);
    one_place.form = VanishingPoints{.count = 3};
    const auto hand = hand_from(0.0, 0.0, 20.0);
    EXPECT_EQ(followed(one_place, hand), hand) << "there is no direction at all";
}

TEST(Perspective, MirroredAndTurnedItLeadsToTheMirroredAndTurnedPlace) {
    for (int count = 1; count <= 3; ++count)
        for (double direction_deg = 3.0; direction_deg < 360.0; direction_deg += 31.0) {
            const auto hand = hand_from(50.0, 90.0, direction_deg);
            std::vector<PenSample> turned;
            for (const PenSample& sample : hand)
                turned.push_back(at(-sample.y_mm, sample.x_mm));
            PenGuide guide = perspective(count);
            const auto straight = followed(guide, hand);
            auto& points = std::get<VanishingPoints>(guide.form);
            points = {count,         -points.y1_mm, points.x1_mm, -points.y2_mm, points.x2_mm,
                      -points.y3_mm, points.x3_mm,  90.0,         180.0};
            const auto other = followed(guide, turned);
            for (std::size_t i = 0; i < hand.size(); ++i) {
                ASSERT_NEAR(other[i].x_mm, -straight[i].y_mm, 1e-9) << count << ", " << direction_deg;
                ASSERT_NEAR(other[i].y_mm, straight[i].x_mm, 1e-9);
            }
        }
}

const PenGuide kGrid{.form = Grid{.x_mm = 5.0,
                                  .y_mm = 3.0,
                                  .spacing_mm = 20.0,
                                  .other_direction_deg = 120.0,
                                  .other_spacing_mm = 30.0},
                     .reach_mm = 4.0};

TEST(Grid, StrokesSnapOntoTheLineWithinReach) {
    // Level lines are at 3, 23, 43...
    expect_on_line(followed(kGrid, hand_from(50.0, 46.5, 10.0)), 0.0, 43.0, 100.0, 43.0);
    expect_on_line(followed(kGrid, hand_from(50.0, -20.0, 190.0)), 0.0, -17.0, 100.0, -17.0);
    expect_on_line(followed(kGrid, hand_from(50.0, 47.5, 10.0)), 0.0, 47.5, 100.0, 47.5);
}

TEST(Grid, TheOtherLinesAreReachedAcrossThem) {
    const double way_x = std::cos(core::radians(120.0)), way_y = std::sin(core::radians(120.0));
    // The next line to the right of the point (5, 3), 30 mm away at right angles.
    const double line_x = 5.0 + 30.0 * way_y, line_y = 3.0 - 30.0 * way_x;
    expect_on_line(followed(kGrid, hand_from(line_x + 3.0, line_y, 110.0)), line_x, line_y,
                   line_x + way_x, line_y + way_y);
    expect_on_line(followed(kGrid, hand_from(line_x + 10.0, line_y, 290.0)), line_x + 10.0, line_y,
                   line_x + 10.0 + way_x, line_y + way_y);
}

TEST(Strength, NoneLeavesTheHandsPathToTheBit) {
    const auto hand = hand_from(50.0, 41.0, 33.0);
    for (PenGuide guide : {perspective(1), perspective(2), perspective(3), kGrid,
                           PenGuide{.form = Ruler{}}, PenGuide{.form = EllipseCurve{}}}) {
        guide.turn_across = true;
        EXPECT_EQ(followed(mixed(guide, 0.0), hand), hand);
    }
}

TEST(Strength, MixesTheHandsPlaceWithTheGuides) {
    const auto hand = hand_from(50.0, 41.0, 33.0);
    for (const PenGuide& guide : {perspective(1), perspective(2), perspective(3), kGrid,
                                  PenGuide{.form = Ruler{0.0, 40.0, 50.0, 70.0}, .reach_mm = 80.0},
                                  PenGuide{.form = EllipseCurve{10.0, 10.0, 40.0, 30.0, 20.0}}}) {
        const auto whole = followed(guide, hand), part = followed(mixed(guide, 0.25), hand);
        for (std::size_t i = 0; i < hand.size(); ++i) {
            EXPECT_NEAR(part[i].x_mm, 0.75 * hand[i].x_mm + 0.25 * whole[i].x_mm, 1e-12);
            EXPECT_NEAR(part[i].y_mm, 0.75 * hand[i].y_mm + 0.25 * whole[i].y_mm, 1e-12);
        }
    }
}

/// Parallel lines and concentric ellipses: a ruler and an ellipse that reach for nothing.
TEST(Strength, WithoutReachEveryStrokeKeepsItsOwnDistance) {
    for (std::uint32_t i = 0; i < 50; ++i) {
        const auto hand = hand_from(60.0 * core::uniform_noise(i, 1), 60.0 * core::uniform_noise(i, 2),
                                    360.0 * core::uniform_noise(i, 3));
        const PenSample& down = hand.front();
        expect_on_line(followed({.form = Ruler{0.0, 0.0, hand.back().x_mm - down.x_mm,
                                               hand.back().y_mm - down.y_mm},
                                 .reach_mm = 0.0},
                                hand),
                       down.x_mm, down.y_mm, hand.back().x_mm, hand.back().y_mm);
        const PenGuide circles{.form = EllipseCurve{30.0, 30.0, 20.0, 20.0, 0.0}, .reach_mm = 0.0};
        const double radius_mm = std::hypot(down.x_mm - 30.0, down.y_mm - 30.0);
        for (const PenSample& place : followed(circles, hand))
            EXPECT_NEAR(std::hypot(place.x_mm - 30.0, place.y_mm - 30.0), radius_mm, 1e-9);
    }
}

}  // namespace
}  // namespace pastoso::brush
