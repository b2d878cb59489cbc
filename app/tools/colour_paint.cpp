#include "tools/colour_paint.hpp"

#include "pigment/appearance.hpp"
#include "pigment/box.hpp"
#include "pigment/paint_name.hpp"

namespace pastoso::tools {

document::PaintRecipe colour_paint(const pigment::Srgb8& colour) {
    return {{{pigment::hex_colour(colour), 1.0}}, 1.0};
}

pigment::Recipe closest_in_box(const pigment::Srgb8& colour) {
    static const pigment::RecipeFinder finder(pigment::default_box());
    return finder.closest(pigment::paint_colour(pigment::decoded(colour)));
}

document::PaintRecipe recipe_paint(const pigment::Recipe& recipe) {
    document::PaintRecipe paint;
    for (const pigment::RecipePart& part : recipe.ingredients)
        paint.ingredients.push_back({part.ci_name, static_cast<double>(part.parts)});
    return paint;
}

std::string painters_recipe(const pigment::Recipe& recipe) {
    std::string text;
    for (const pigment::RecipePart& part : recipe.ingredients) {
        text += text.empty() ? "" : " + ";
        if (recipe.ingredients.size() > 1) text += std::to_string(part.parts) + " ";
        text += pigment::painters_name(part.ci_name);
    }
    return text;
}

}  // namespace pastoso::tools
