#include "brush/symmetry.hpp"

#include "core/units.hpp"

#include <cmath>

#include <gtest/gtest.h>

namespace pastoso::brush {
namespace {

HandPose some_hand() {
    HandPose hand;
    hand.x_mm = 37.0;
    hand.y_mm = 12.0;
    hand.travel_x = 0.6;
    hand.travel_y = 0.8;
    hand.press = 0.4;
    hand.lean_x = 0.25;
    hand.lean_y = -0.5;
    hand.cos_rotation = 0.8;
    hand.sin_rotation = 0.6;
    return hand;
}

TEST(Symmetry, OfNothingIsTheHandItself) {
    const auto copies = placements({});
    ASSERT_EQ(copies.size(), 1U);
    const HandPose hand = some_hand(), same = placed(copies[0], hand);
    EXPECT_EQ(same.x_mm, hand.x_mm);
    EXPECT_EQ(same.lean_y, hand.lean_y);
    EXPECT_EQ(same.cos_rotation, hand.cos_rotation);
    EXPECT_EQ(same.press, hand.press);
}

TEST(Symmetry, HasAMirrorImageForEveryCopy) {
    EXPECT_EQ(placements({.mirror = true}).size(), 2U);
    EXPECT_EQ(placements({.count = 16}).size(), 16U);
    const auto copies = placements({.mirror = true, .count = 5});
    ASSERT_EQ(copies.size(), 10U);
    for (std::size_t i = 0; i < copies.size(); ++i) {
        EXPECT_EQ(copies[i].mirrored, i % 2 == 1);
        const double determinant = copies[i].xx * copies[i].yy - copies[i].xy * copies[i].yx;
        EXPECT_NEAR(determinant, copies[i].mirrored ? -1.0 : 1.0, 1e-15);
    }
}

TEST(Symmetry, AnUprightMirrorIsExact) {
    const auto copies = placements({.centre_x_mm = 50.0, .centre_y_mm = 7.0, .mirror = true});
    const HandPose hand = some_hand(), image = placed(copies[1], hand);
    EXPECT_EQ(image.x_mm, 63.0);
    EXPECT_EQ(image.y_mm, 12.0);
    EXPECT_EQ(image.travel_x, -0.6);
    EXPECT_EQ(image.travel_y, 0.8);
    EXPECT_EQ(image.lean_x, -0.25);
    EXPECT_EQ(image.lean_y, -0.5);
    // A barrel turned by a is turned by -a in the mirror.
    EXPECT_EQ(image.cos_rotation, 0.8);
    EXPECT_EQ(image.sin_rotation, -0.6);
}

TEST(Symmetry, QuarterTurnsAreExact) {
    const auto copies = placements({.centre_x_mm = 10.0, .centre_y_mm = 20.0, .count = 4});
    const HandPose hand = some_hand();
    const HandPose quarter = placed(copies[1], hand), half = placed(copies[2], hand);
    EXPECT_EQ(quarter.x_mm, 10.0 + 8.0);
    EXPECT_EQ(quarter.y_mm, 20.0 + 27.0);
    EXPECT_EQ(quarter.lean_x, 0.5);
    EXPECT_EQ(quarter.cos_rotation, -0.6);
    EXPECT_EQ(quarter.sin_rotation, 0.8);
    EXPECT_EQ(half.x_mm, -17.0);
    EXPECT_EQ(half.travel_y, -0.8);
}

TEST(Symmetry, ReflectsAtAnyAxis) {
    const double axis_deg = 25.0, axis = core::radians(axis_deg);
    const Symmetry symmetry{
        .centre_x_mm = 3.0, .centre_y_mm = 4.0, .axis_deg = axis_deg, .mirror = true};
    const HandPose hand = some_hand(), image = placed(placements(symmetry)[1], hand);
    const double along = std::cos(axis), up = std::sin(axis);
    const auto across = [&](double x, double y) { return y * along - x * up; };
    const auto beside = [&](double x, double y) { return x * along + y * up; };
    EXPECT_NEAR(across(image.x_mm - 3.0, image.y_mm - 4.0), -across(34.0, 8.0), 1e-12);
    EXPECT_NEAR(beside(image.x_mm - 3.0, image.y_mm - 4.0), beside(34.0, 8.0), 1e-12);
    EXPECT_NEAR(across(image.travel_x, image.travel_y), -across(0.6, 0.8), 1e-15);
    // The mirrored tip's x axis runs against the image of the hand's.
    EXPECT_NEAR(beside(image.cos_rotation, image.sin_rotation), -beside(0.8, 0.6), 1e-15);
    EXPECT_NEAR(across(image.cos_rotation, image.sin_rotation), across(0.8, 0.6), 1e-15);
}

TEST(Symmetry, TheMirroredTipIsTheImageOfTheTip) {
    const Tip tip = make_tip(find_preset("flat"), 3);
    const Tip image = mirrored(tip);
    EXPECT_TRUE(image.mirrored);
    const int last = tip.hair_count() - 1;
    for (int i = 0; i < static_cast<int>(tip.bristles.size()); ++i) {
        EXPECT_EQ(image.bristles[i].root_x_mm, -tip.bristles[i].root_x_mm);
        EXPECT_EQ(image.bristles[i].root_y_mm, tip.bristles[i].root_y_mm);
        EXPECT_EQ(image.bristles[i].body, tip.bristles[i].body);
        EXPECT_EQ(image.hairs_of(i)[0], tip.hairs_of(i)[last]);
    }
    const Tip back = mirrored(image);
    EXPECT_EQ(back.hairs, tip.hairs);
    EXPECT_FALSE(back.mirrored);
}

}  // namespace
}  // namespace pastoso::brush
