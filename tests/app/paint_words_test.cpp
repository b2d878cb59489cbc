#include "panels/paint/paint_words.hpp"

#include <gtest/gtest.h>

namespace pastoso::panels {
namespace {

TEST(PaintWords, ATubeIsCalledByItsName) {
    EXPECT_EQ(recipe_words({{{"PW6", 1.0}}, 1.0}), QStringLiteral("Titanium white"));
    EXPECT_EQ(recipe_words({{{"#c03020", 1.0}}, 1.0}), QStringLiteral("#c03020"));
    EXPECT_EQ(recipe_words({}), QStringLiteral("Clear medium"));
}

TEST(PaintWords, AMixtureTellsItsParts) {
    EXPECT_EQ(recipe_words({{{"PW6", 8.0}, {"PB29", 1.0}}, 1.0}),
              QStringLiteral("8 Titanium white + 1 Ultramarine blue"));
}

TEST(PaintWords, SharesAreWholePercentsAndTenthsOfTheSmall) {
    EXPECT_EQ(share_words({{{"PB29", 31.0}, {"PW6", 19.0}}, 1.0}),
              QStringLiteral("PB29 62 %, PW6 38 %"));
    EXPECT_EQ(share_words({{{"PB29", 1.0}, {"PW6", 39.0}}, 1.0}),
              QStringLiteral("PB29 2.5 %, PW6 98 %"));
    EXPECT_EQ(share_words({{{"PB29", 1.0}}, 0.4}), QStringLiteral("PB29, thinned to 40 %"));
    EXPECT_EQ(share_words({}), QStringLiteral("clear medium"));
}

}  // namespace
}  // namespace pastoso::panels
