#include "tools/colour_paint.hpp"

#include <algorithm>

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

TEST(FromTubes, LeavesTubesAsTheyAre) {
    const document::PaintRecipe sky{{{"PB29", 62.0}, {"PW6", 38.5}}, 0.4};
    EXPECT_EQ(from_tubes(sky), sky);
    EXPECT_EQ(from_tubes({}), document::PaintRecipe{});
}

TEST(FromTubes, AColourIsItsClosestRecipe) {
    const pigment::Srgb8 colour = {0x7a, 0x5c, 0x3e};
    document::PaintRecipe wanted = recipe_paint(closest_in_box(colour));
    wanted.strength = 0.5;
    EXPECT_EQ(from_tubes({{{"#7a5c3e", 3.0}}, 0.5}), wanted);
}

TEST(FromTubes, AColourInAMixtureHasAsManyPartsTogether) {
    const document::PaintRecipe mixed = from_tubes({{{"#7a5c3e", 3.0}, {"PW6", 1.0}}, 1.0});
    double sum = 0.0;
    for (const document::Ingredient& part : mixed.ingredients) {
        EXPECT_EQ(part.pigment.front(), 'P');
        sum += part.parts;
    }
    EXPECT_NEAR(sum, 4.0, 1e-12);
    const auto whites = std::count_if(mixed.ingredients.begin(), mixed.ingredients.end(),
                                      [](const auto& part) { return part.pigment == "PW6"; });
    EXPECT_EQ(whites, 1);
}

}  // namespace
}  // namespace pastoso::tools
