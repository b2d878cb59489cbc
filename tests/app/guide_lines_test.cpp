#include "interactions/guide_lines.hpp"

#include "interactions/guide_ways.hpp"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

namespace pastoso::interactions {
namespace {

constexpr glm::dvec2 kCanvas_mm{60.0, 40.0};

tools::Hand symmetric(bool mirror, int count) {
    tools::Hand hand;
    hand.symmetry = {.centre_x_mm = 30.0, .centre_y_mm = 20.0, .mirror = mirror, .count = count};
    return hand;
}

void expect_line(const std::vector<glm::vec2>& lines, std::size_t line, const glm::vec2& from,
                 const glm::vec2& to) {
    ASSERT_GE(lines.size(), 2 * line + 2);
    EXPECT_NEAR(lines[2 * line].x, from.x, 1e-4F);
    EXPECT_NEAR(lines[2 * line].y, from.y, 1e-4F);
    EXPECT_NEAR(lines[2 * line + 1].x, to.x, 1e-4F);
    EXPECT_NEAR(lines[2 * line + 1].y, to.y, 1e-4F);
}

TEST(GuideLines, AreNoneWithoutGuides) {
    EXPECT_TRUE(guide_lines_mm(tools::Hand{}, kCanvas_mm).empty());
}

TEST(GuideLines, TheMirrorsAxisRunsFromEdgeToEdge) {
    const auto lines = guide_lines_mm(symmetric(true, 1), kCanvas_mm);
    ASSERT_EQ(lines.size(), 2U);
    expect_line(lines, 0, {30.0F, 0.0F}, {30.0F, 40.0F});
}

TEST(GuideLines, RaysPartTheCopies) {
    const auto lines = guide_lines_mm(symmetric(false, 4), kCanvas_mm);
    ASSERT_EQ(lines.size(), 8U);
    expect_line(lines, 0, {30.0F, 20.0F}, {30.0F, 40.0F});
    expect_line(lines, 1, {30.0F, 20.0F}, {0.0F, 20.0F});
    EXPECT_EQ(guide_lines_mm(symmetric(true, 4), kCanvas_mm).size(), 8U);
}

TEST(GuideLines, TheRulerHasNoEnds) {
    tools::Hand hand;
    hand.laid.form = brush::Ruler{10.0, 10.0, 20.0, 20.0};
    const auto lines = guide_lines_mm(hand, kCanvas_mm);
    ASSERT_EQ(lines.size(), 2U);
    expect_line(lines, 0, {0.0F, 0.0F}, {40.0F, 40.0F});
    hand.laid.form = brush::Ruler{100.0, 0.0, 100.0, 10.0};  // beside the canvas
    EXPECT_TRUE(guide_lines_mm(hand, kCanvas_mm).empty());
}

TEST(GuideLines, TheHorizonRunsThroughTheVanishingPoints) {
    tools::Hand hand;
    hand.laid.form = brush::VanishingPoints{
        .count = 2, .x1_mm = -100.0, .y1_mm = 10.0, .x2_mm = 300.0, .y2_mm = 10.0};
    const auto lines = guide_lines_mm(hand, kCanvas_mm);
    ASSERT_EQ(lines.size(), 2U);
    expect_line(lines, 0, {0.0F, 10.0F}, {60.0F, 10.0F});
}

TEST(Ways, OfARulerAndAnEllipseThereAreNoneUnlessTheyReachForNothing) {
    brush::PenGuide guide{.form = brush::Ruler{0.0, 20.0, 60.0, 20.0}};
    EXPECT_TRUE(ways_mm(guide, kCanvas_mm).empty());
    guide.reach_mm = 0.0;
    const auto parallels = ways_mm(guide, kCanvas_mm);
    ASSERT_GE(parallels.size(), 10U);
    for (std::size_t i = 0; i < parallels.size(); i += 2)
        EXPECT_NEAR(parallels[i].y, parallels[i + 1].y, 1e-3F);
    guide = {.form = brush::EllipseCurve{30.0, 20.0, 8.0, 8.0, 0.0}};
    EXPECT_TRUE(ways_mm(guide, kCanvas_mm).empty());
    guide.reach_mm = 0.0;
    EXPECT_FALSE(ways_mm(guide, kCanvas_mm).empty());
}

TEST(Ways, OfAGridAreItsLines) {
    const brush::PenGuide guide{.form = brush::Grid{30.0, 20.0, 0.0, 15.0, 90.0, 25.0}};
    const auto lines = ways_mm(guide, kCanvas_mm);
    ASSERT_EQ(lines.size(), 12U);
    expect_line(lines, 0, {0.0F, 5.0F}, {60.0F, 5.0F});
    expect_line(lines, 2, {0.0F, 35.0F}, {60.0F, 35.0F});
    EXPECT_NEAR(lines[6].x, 55.0F, 1e-3F);
    EXPECT_NEAR(lines[10].x, 5.0F, 1e-3F);
}

TEST(Ways, OfAFineGridAreNotTooMany) {
    const brush::PenGuide guide{.form = brush::Grid{.spacing_mm = 0.1, .other_spacing_mm = 0.1}};
    const auto lines = ways_mm(guide, kCanvas_mm);
    EXPECT_GT(lines.size(), 100U);
    EXPECT_LE(lines.size(), 404U);
}

TEST(Ways, OfAPerspectiveLeadToItsPoints) {
    const brush::PenGuide guide{
        .form = brush::VanishingPoints{.count = 2, .x1_mm = 20.0, .y1_mm = 10.0, .x2_mm = 300.0}};
    const auto lines = ways_mm(guide, kCanvas_mm);
    ASSERT_GT(lines.size(), 40U);
    for (std::size_t i = 0; i < lines.size(); i += 2) {
        const auto off = [&](const glm::vec2& point) {
            const glm::vec2 way = lines[i + 1] - lines[i], to = point - lines[i];
            return std::abs(way.x * to.y - way.y * to.x) / std::hypot(way.x, way.y);
        };
        EXPECT_LT(std::min(off({20.0F, 10.0F}), off({300.0F, 0.0F})), 1e-2F);
    }
}

}  // namespace
}  // namespace pastoso::interactions
