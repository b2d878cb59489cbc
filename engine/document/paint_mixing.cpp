#include "document/paint_mixing.hpp"

#include "pigment/palette.hpp"

#include <vector>

namespace pastoso::document {

pigment::Coefficients coefficients_of(const PaintRecipe& paint) {
    std::vector<pigment::Portion> portions;
    portions.reserve(paint.ingredients.size());
    for (const Ingredient& ingredient : paint.ingredients) {
        portions.push_back({pigment::find_pigment(ingredient.pigment).coefficients, ingredient.parts});
    }
    pigment::Coefficients coefficients = pigment::mix(portions);
    for (float& value : coefficients)
        value *= static_cast<float>(paint.strength);
    return coefficients;
}

}  // namespace pastoso::document
