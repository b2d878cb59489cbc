#include "document/paint_mixing.hpp"

#include "pigment/paint_name.hpp"
#include "pigment/palette.hpp"

#include <vector>

namespace pastoso::document {

film::PaintCoefficients mixed_paint(const PaintRecipe& paint, const film::Medium& medium) {
    if (paint.ingredients.empty()) return film::paint_coefficients({}, medium);
    std::vector<pigment::Portion> portions;
    portions.reserve(paint.ingredients.size());
    for (const Ingredient& ingredient : paint.ingredients) {
        portions.push_back({pigment::named_paint(ingredient.pigment), ingredient.parts});
    }
    pigment::Coefficients coefficients = pigment::mix(portions);
    for (float& value : coefficients)
        value *= static_cast<float>(paint.strength);
    return film::paint_coefficients(coefficients, medium);
}

}  // namespace pastoso::document
