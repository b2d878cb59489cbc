#include "brush/tip.hpp"

#include "brush/studio.hpp"

#include <algorithm>
#include <cmath>
#include <set>

#include <gtest/gtest.h>

namespace pastoso::brush {
namespace {

TEST(Tip, FillsAFlatEvenly) {
    const Preset preset = studio::flat_preset(20.0);
    const Tip tip = make_tip(preset, 1);
    ASSERT_EQ(tip.bristles.size(), 300U);
    // Ten equal slices of the width hold thirty bristles each, give or take a few that were shaken
    // across.
    std::array<int, 10> slices{};
    for (const Bristle& bristle : tip.bristles) {
        ++slices[std::clamp(static_cast<int>(std::floor((bristle.root_x_mm + 10.0F) / 2.0F)), 0, 9)];
        EXPECT_LE(std::abs(bristle.root_x_mm), 10.6F);
        EXPECT_LE(std::abs(bristle.root_y_mm), 3.0F);
    }
    for (const int count : slices)
        EXPECT_NEAR(count, 30, 8);
}

TEST(Tip, KeepsARoundWithinItsCircle) {
    const Tip tip = make_tip(studio::round_preset(10.0), 3);
    ASSERT_EQ(tip.bristles.size(), 300U);
    for (const Bristle& bristle : tip.bristles) {
        EXPECT_LE(std::hypot(bristle.root_x_mm, bristle.root_y_mm), 5.0F + 1e-5F);
    }
}

TEST(Tip, EndsTheMarkOfARollerStraight) {
    const Preset preset = resized(find_preset("roller"), 20.0);
    const Tip tip = make_tip(preset, 1);
    const double end_mm = 0.5 * preset.tip.width_mm - tip.radius_mm;
    int at_the_end = 0;
    for (const Bristle& bristle : tip.bristles) {
        ASSERT_LE(std::abs(bristle.root_x_mm), end_mm + 1e-5);
        at_the_end += bristle.root_x_mm > end_mm - 1e-5 ? 1 : 0;
    }
    EXPECT_GT(2.0 * tip.radius_mm * at_the_end, preset.tip.girth_mm) << "they close the line";
}

TEST(Tip, PointsARoundAndAFilbert) {
    const Tip round = make_tip(studio::round_preset(10.0), 1);
    for (const Bristle& bristle : round.bristles) {
        const float radius = std::hypot(bristle.root_x_mm, bristle.root_y_mm) / 5.0F;
        if (radius < 0.1F) {
            EXPECT_LT(bristle.deficit_mm, 1.0F);
        }
        if (radius > 0.95F) {
            EXPECT_GT(bristle.deficit_mm, 6.0F);
        }
    }
    const Tip filbert = make_tip(find_preset("filbert"), 1);
    for (const Bristle& bristle : filbert.bristles) {
        if (std::abs(bristle.root_x_mm) > 6.8F) {
            EXPECT_GT(bristle.deficit_mm, 3.0F);
        }
    }
}

class EveryTip : public testing::TestWithParam<const char*> {};

TEST_P(EveryTip, HasSoundBristles) {
    const Preset& preset = find_preset(GetParam());
    const Tip tip = make_tip(preset, 5);
    ASSERT_EQ(static_cast<int>(tip.bristles.size()), preset.tip.bristles);
    ASSERT_EQ(tip.hairs.size(), tip.bristles.size() * 17);
    float shortest = 1e9F;
    for (const Bristle& bristle : tip.bristles) {
        shortest = std::min(shortest, bristle.deficit_mm);
        EXPECT_GE(bristle.body, 0.03F);
        EXPECT_LE(bristle.body, 1.4F);
        EXPECT_GE(bristle.stiffness, 0.8F);
        EXPECT_LE(bristle.stiffness, 1.2F);
    }
    EXPECT_EQ(shortest, 0.0F);  // the longest bristle is what the others are measured from
    // All bristles full carry what a stroke of the preset's run takes.
    const double capacity_mm3 = tip.capacity_mm3 * preset.tip.bristles;
    EXPECT_NEAR(capacity_mm3, preset.paint.film_mm * preset.paint.run_mm * preset.tip.width_mm, 1e-9);
}

TEST_P(EveryTip, HasNeighboursOnceEach) {
    const Tip tip = make_tip(find_preset(GetParam()), 1);
    const std::set<std::pair<int, int>> once(tip.neighbours.begin(), tip.neighbours.end());
    EXPECT_EQ(once.size(), tip.neighbours.size());
    EXPECT_GE(tip.neighbours.size(), 2 * tip.bristles.size());
    for (const auto& [first, second] : tip.neighbours)
        EXPECT_LT(first, second);
}

TEST_P(EveryTip, IsTheSameForTheSameSeedOnly) {
    const Preset& preset = find_preset(GetParam());
    const Tip a = make_tip(preset, 7), b = make_tip(preset, 7), c = make_tip(preset, 8);
    EXPECT_EQ(a.hairs, b.hairs);
    EXPECT_NE(a.hairs, c.hairs);
    int same_body = 0;
    for (std::size_t i = 0; i < a.bristles.size(); ++i) {
        EXPECT_EQ(a.bristles[i].root_x_mm, b.bristles[i].root_x_mm);
        EXPECT_EQ(a.bristles[i].body, b.bristles[i].body);
        same_body += a.bristles[i].body == c.bristles[i].body ? 1 : 0;
    }
    EXPECT_LT(same_body, static_cast<int>(a.bristles.size()) / 4);  // some are cut off at the same limit
}

INSTANTIATE_TEST_SUITE_P(Presets, EveryTip, testing::Values("flat", "round", "filbert", "fan", "knife"));

TEST(Tip, MakesAKnifeARow) {
    const Tip knife = make_tip(find_preset("knife"), 1);
    EXPECT_TRUE(knife.rigid);
    for (std::size_t i = 0; i < knife.bristles.size(); ++i) {
        EXPECT_NEAR(knife.bristles[i].root_x_mm, -8.5 + 17.0 * (static_cast<double>(i) + 0.5) / 70.0,
                    1e-5);
        EXPECT_EQ(knife.bristles[i].root_y_mm, 0.0F);
        EXPECT_EQ(knife.bristles[i].deficit_mm, 0.0F);
    }
}

}  // namespace
}  // namespace pastoso::brush
