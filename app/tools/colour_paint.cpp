#include "tools/colour_paint.hpp"

#include "pigment/appearance.hpp"
#include "pigment/box.hpp"
#include "pigment/paint_name.hpp"
#include "pigment/user_pigments.hpp"

#include <algorithm>
#include <string>

namespace pastoso::tools {
namespace {

std::vector<pigment::Pigment> tubes_at_hand() {
    std::vector<pigment::Pigment> tubes = pigment::default_box();
    const auto& own = pigment::user_pigments().pigments;
    tubes.insert(tubes.end(), own.begin(), own.end());
    return tubes;
}

void add_part(const std::string& pigment, double parts, document::PaintRecipe& paint) {
    const auto same = std::find_if(paint.ingredients.begin(), paint.ingredients.end(),
                                   [&](const auto& part) { return part.pigment == pigment; });
    if (same == paint.ingredients.end())
        paint.ingredients.push_back({pigment, parts});
    else
        same->parts += parts;
}

}  // namespace

document::PaintRecipe colour_paint(const pigment::Srgb8& colour) {
    return {{{pigment::hex_colour(colour), 1.0}}, 1.0};
}

pigment::Recipe closest_in_box(const pigment::Srgb8& colour) {
    static const pigment::RecipeFinder finder(tubes_at_hand());
    return finder.closest(pigment::paint_colour(pigment::decoded(colour)));
}

document::PaintRecipe recipe_paint(const pigment::Recipe& recipe) {
    document::PaintRecipe paint;
    for (const pigment::RecipePart& part : recipe.ingredients)
        paint.ingredients.push_back({part.ci_name, static_cast<double>(part.parts)});
    return paint;
}

document::PaintRecipe from_tubes(const document::PaintRecipe& paint) {
    const auto is_colour = [](const auto& part) { return pigment::names_a_colour(part.pigment); };
    if (std::none_of(paint.ingredients.begin(), paint.ingredients.end(), is_colour)) return paint;
    document::PaintRecipe mixed{{}, paint.strength};
    const bool alone = paint.ingredients.size() == 1;
    for (const document::Ingredient& part : paint.ingredients) {
        const auto colour = pigment::parse_hex_colour(part.pigment);
        if (!colour) {
            add_part(part.pigment, part.parts, mixed);
            continue;
        }
        const document::PaintRecipe recipe = recipe_paint(closest_in_box(*colour));
        double sum = 0.0;
        for (const document::Ingredient& tube : recipe.ingredients)
            sum += tube.parts;
        // Round parts stay round where nothing else is in it.
        const double scale = alone ? 1.0 : part.parts / sum;
        for (const document::Ingredient& tube : recipe.ingredients)
            add_part(tube.pigment, scale * tube.parts, mixed);
    }
    return mixed;
}

}  // namespace pastoso::tools
