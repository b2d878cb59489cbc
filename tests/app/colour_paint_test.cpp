#include "tools/colour_paint.hpp"

#include <gtest/gtest.h>

namespace pastoso::tools {
namespace {

TEST(ColourPaint, IsTheColourItself) {
    EXPECT_EQ(colour_paint({0xc0, 0x30, 0x20}), (document::PaintRecipe{{{"#c03020", 1.0}}, 1.0}));
}

TEST(ColourPaint, WhiteIsTitaniumWhite) {
    const pigment::Recipe recipe = closest_in_box({255, 255, 255});
    EXPECT_EQ(recipe_paint(recipe), (document::PaintRecipe{{{"PW6", 1.0}}, 1.0}));
}

TEST(ColourPaint, ARecipeKeepsItsParts) {
    const pigment::Recipe recipe{{{"PW6", 8}, {"PB29", 1}}, 0.5};
    EXPECT_EQ(recipe_paint(recipe), (document::PaintRecipe{{{"PW6", 8.0}, {"PB29", 1.0}}, 1.0}));
}

}  // namespace
}  // namespace pastoso::tools
