#include "tools/colour_paint.hpp"

#include "pigment/appearance.hpp"
#include "pigment/box.hpp"
#include "pigment/user_pigments.hpp"

namespace pastoso::tools {
namespace {

std::vector<pigment::Pigment> tubes_at_hand() {
    std::vector<pigment::Pigment> tubes = pigment::default_box();
    const auto& own = pigment::user_pigments().pigments;
    tubes.insert(tubes.end(), own.begin(), own.end());
    return tubes;
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

}  // namespace pastoso::tools
