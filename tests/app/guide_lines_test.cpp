#include "interactions/guide_lines.hpp"

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
    hand.ruler = {10.0, 10.0, 20.0, 20.0};
    const auto lines = guide_lines_mm(hand, kCanvas_mm);
    ASSERT_EQ(lines.size(), 2U);
    expect_line(lines, 0, {0.0F, 0.0F}, {40.0F, 40.0F});
    hand.ruler = {100.0, 0.0, 100.0, 10.0};  // beside the canvas
    EXPECT_TRUE(guide_lines_mm(hand, kCanvas_mm).empty());
}

}  // namespace
}  // namespace pastoso::interactions
