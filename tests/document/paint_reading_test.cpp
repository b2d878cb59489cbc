#include "document/paint_reading.hpp"

#include "document/paint_mixing.hpp"
#include "document/painting.hpp"
#include "film/thinning.hpp"
#include "pigment/paint_name.hpp"

#include <algorithm>

#include <gtest/gtest.h>

namespace pastoso::document {
namespace {

using Names = std::vector<std::string>;

const Names kOnThePalette = {"PW6", "PB29", "PR108", "PY35", "PBk9", "#c03020"};

pigment::Coefficients coefficients_of(const PaintRecipe& recipe, const film::Medium& medium = {}) {
    const film::PaintCoefficients paint = mixed_paint(recipe, medium);
    pigment::Coefficients colour{};
    std::copy_n(paint.begin(), colour.size(), colour.begin());
    return colour;
}

TEST(NotePaints, NamesEveryPaintOnce) {
    Names names;
    note_paints(
        LoadPaint{.paint = {{{"PB29", 1.0}, {"PW6", 2.0}}, 1.0}, .second = {{{"PB29", 1.0}}, 1.0}},
        names);
    note_paints(SqueezePaint{.paint = {{{"#c03020", 1.0}}, 1.0}}, names);
    note_paints(CleanBrush{}, names);
    EXPECT_EQ(names, (Names{"PB29", "PW6", "#c03020"}));
}

TEST(RecipeOf, IsTheMixtureThatWasMixed) {
    const PaintRecipe mixed{{{"PB29", 62.0}, {"PW6", 38.0}}, 1.0};
    EXPECT_EQ(recipe_of(coefficients_of(mixed), kOnThePalette), mixed);
    const PaintRecipe thinned{{{"#c03020", 50.0}, {"PY35", 30.0}, {"PW6", 20.0}}, 0.4};
    EXPECT_EQ(recipe_of(coefficients_of(thinned), kOnThePalette), thinned);
}

/// Full-strength paint in ink glaze and in a stain of it, and thinner paint in oil.
TEST(RecipeOf, PaintOfAGlazeIsAsStrongInThatGlaze) {
    const PaintRecipe full{{{"PB29", 62.0}, {"PW6", 38.0}}, 1.0};
    const PaintRecipe half{{{"PB29", 62.0}, {"PW6", 38.0}}, 0.5};
    const film::Medium& glaze = film::find_medium("ink glaze");
    for (const film::Medium& medium : {glaze, film::thinned(glaze, film::kLeastPaintShare)})
        for (const PaintRecipe& paint : {full, half})
            EXPECT_EQ(recipe_of(coefficients_of(paint, medium), kOnThePalette, medium.pigment_share),
                      paint);
    const auto in_oil = recipe_of(coefficients_of(full, glaze), kOnThePalette);
    ASSERT_TRUE(in_oil.has_value());
    EXPECT_EQ(in_oil->strength, 0.03);
    EXPECT_EQ(recipe_of(coefficients_of(full), kOnThePalette, glaze.pigment_share), full);
}

TEST(RecipeOf, OneTubeIsOnePart) {
    const PaintRecipe tube{{{"PR108", 1.0}}, 1.0};
    EXPECT_EQ(recipe_of(coefficients_of(tube), kOnThePalette), tube);
}

TEST(RecipeOf, PaintDenserThanFromTheTubeIsAsStrongAsThat) {
    pigment::Coefficients dense = pigment::named_paint("PB29");
    for (float& value : dense)
        value *= 1.4F;
    EXPECT_EQ(recipe_of(dense, kOnThePalette), (PaintRecipe{{{"PB29", 1.0}}, 1.0}));
}

TEST(RecipeOf, MediumAloneHasNoIngredientsAndForeignPaintNoRecipe) {
    EXPECT_EQ(recipe_of({}, kOnThePalette), PaintRecipe{});
    EXPECT_EQ(recipe_of(pigment::named_paint("PG7"), Names{"PW6", "PR108"}), std::nullopt);
    EXPECT_EQ(recipe_of(pigment::named_paint("PG7"), Names{}), std::nullopt);
}

/// Through the brush, the film and its drying: what the tubes gave is what is read.
TEST(RecipeOf, APaintedStrokeIsWhatTheBrushWasDippedIn) {
    core::ThreadPool pool(1);
    Painting painting({.width_mm = 40.0, .height_mm = 30.0, .px_per_mm = 4.0, .support = "panel"}, pool);
    const PaintRecipe mixed{{{"PB29", 70.0}, {"PW6", 30.0}}, 1.0};
    Names names = {"PR108"};
    painting.apply(UseMedium{"heavy-body oil"});
    painting.apply(TakeBrush{"flat"});
    const LoadPaint load{.paint = mixed};
    note_paints(load, names);
    painting.apply(load);
    painting.apply(PenDown{{.time_s = 0.0, .x_mm = 10.0, .y_mm = 15.0, .pressure = 0.6}});
    for (int i = 1; i <= 20; ++i)
        painting.apply(PenMove{{.time_s = 0.01 * i, .x_mm = 10.0 + i, .y_mm = 15.0, .pressure = 0.6}});
    painting.apply(PenUp{});
    for (const bool dry : {false, true}) {
        if (dry) painting.apply(DryNow{});
        const film::PaintSample sample = film::sample_paint(painting.film(), 20.0, 15.0, 1.0);
        EXPECT_EQ(sample.layer, dry ? film::PaintLayer::Dry : film::PaintLayer::Wet);
        const auto found = recipe_of(sample.coefficients, names);
        ASSERT_TRUE(found.has_value());
        ASSERT_EQ(found->ingredients.size(), 2U);
        EXPECT_EQ(found->ingredients[0].pigment, "PB29");
        EXPECT_EQ(found->ingredients[1].pigment, "PW6");
        // Every transfer rounds to whole quanta: a tenth of a percent, the step of the parts.
        EXPECT_NEAR(found->ingredients[0].parts, 70.0, 0.11);
        EXPECT_NEAR(found->ingredients[1].parts, 30.0, 0.11);
    }
}

}  // namespace
}  // namespace pastoso::document
